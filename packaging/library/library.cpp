// The functions of quell.h. Compiled for the oldest machine, without any header of quell's.
#define QUELL_CALL __attribute__((visibility("default")))
#include "quell.h"

#include "calls.hpp"
#include "cuda/cuda_code.hpp"
#include "name_list.hpp"
#include "own_threads.hpp"
#include "preset_code.hpp"

#include <dispatch/machine_runs.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>

extern "C" quell_library::CodesOf QUELL_ENTRIES;

namespace {

using namespace quell_library;

/// Code for one instruction set.
struct Code {
    char const* name;
    CodesOf* all;
    bool runs_anywhere; ///< it is for the machine that it was built on
};
constexpr Code codes[] = {QUELL_CODES}; // the best first
constexpr Code cuda_code{"cuda", +[] { return cuda_codes(); }, true};

bool runs_here(Code const& code) { return code.runs_anywhere || machine_runs(code.name); }

std::string joined(auto const& list, auto&& name) {
    std::string text;
    for (auto const& each : list) (text += text.empty() ? "" : ", ") += name(each);
    return text;
}

/// Code for the instruction set that was asked for, or the best that the machine has; null and a sentence where there is none.
Code const* code_for(char const* wanted, quell_status& status) {
    for (auto const& code : codes)
        if (wanted == nullptr ? runs_here(code) : code.name == std::string_view(wanted)) {
            if (runs_here(code)) return &code;
            status = fail(QUELL_NOT_SUPPORTED, "instruction_set: this machine lacks " + std::string(wanted) + "; leave it null");
            return nullptr;
        }
    auto const all = joined(codes, [](auto const& code) { return code.name; });
    status = fail(QUELL_NOT_SUPPORTED, wanted == nullptr ? "the machine: it lacks all instruction sets of this library (" + all + ")"
                                                         : "instruction_set: '" + std::string(wanted) + "'; give one of: " + all);
    return nullptr;
}

Sizes sizes_of(quell_settings const& settings) {
    bool const is_said = settings.output_width != 0 || settings.output_height != 0;
    return {settings.width, settings.height, is_said ? settings.output_width : settings.width,
            is_said ? settings.output_height : settings.height};
}
bool is_resized(quell_settings const& settings) {
    auto const sizes = sizes_of(settings);
    return sizes.output_width != sizes.width || sizes.output_height != sizes.height;
}

/// A sentence where a device can't do what the settings ask for.
std::string check_device(quell_settings const& settings) {
    for (auto const& [name, is_set] : {std::pair{"alpha", settings.alpha != 0},
                                       {"an output of another size", is_resized(settings)},
                                       {"allocate", settings.allocate != nullptr},
                                       {"instruction_set", settings.instruction_set != nullptr}})
        if (is_set)
            return std::string("settings.device: QUELL_CUDA with ") + name + ", which a device does not know; leave one of the two out";
    return {};
}

/// All that a device is compiled for; null: nothing.
Codes const* codes_of(std::int32_t device) {
    if (device == QUELL_CUDA) return cuda_codes();
    auto const* const code = std::ranges::find_if(codes, runs_here);
    return device == QUELL_CPU && code != std::end(codes) ? code->all() : nullptr;
}

struct Range {
    std::byte const *begin, *end;
};
/// All memory of an image.
Range range_of(Image const& image, int components, int width, int height) {
    auto const element = static_cast<std::ptrdiff_t>(image.is_half ? 2 : 4);
    std::byte const *least = image.data, *most = image.data;
    for (auto const& [stride, count] :
         {std::pair{image.component_stride, components}, {image.pixel_stride, width}, {image.row_stride, height}})
        (stride < 0 ? least : most) += stride * (count - 1);
    return {least, most + element};
}

} // namespace

struct quell_denoiser {
    Code const* code;
    PresetCode const* preset;
    std::shared_ptr<PresetWay const> way;
    quell_motion motion;
    bool two_sided;
    bool resolves;
    Sizes sizes;
    int guide_width; ///< of the frame that was run last
    OwnThreads threads;
    std::string plan;
    std::unique_ptr<Instance> instance;
    std::atomic<bool> busy = false;
    std::vector<Frame> frames;
    Image output;

    /// A channel that it reads; null where it reads none of that name.
    [[nodiscard]] Channel const* channel(std::string_view name) const {
        auto const found = std::ranges::find(way->channels, name, &Channel::name);
        return found != way->channels.end() ? &*found : nullptr;
    }
};

namespace {

/// Marks a denoiser as running for as long as this lives.
class Running {
    std::atomic<bool>& busy;

public:
    bool const first;
    explicit Running(quell_denoiser& denoiser) : busy(denoiser.busy), first(!denoiser.busy.exchange(true)) {}
    ~Running() {
        if (first) busy = false;
    }
    Running(Running const&) = delete;
    Running& operator=(Running const&) = delete;
};

std::string size(int width, int height) { return std::to_string(width) + "x" + std::to_string(height); }

/// Whether an output is 1 to `most_ratio` times as wide and high as frames.
bool is_ratio(Sizes const& sizes) {
    constexpr std::int64_t most_ratio = 4;
    return sizes.output_width >= sizes.width && sizes.output_width <= most_ratio * sizes.width && sizes.output_height >= sizes.height &&
           sizes.output_height <= most_ratio * sizes.height;
}

/// A sentence where samples can't be taken. Fills in what stands for itself.
std::string take_samples(Samples& to, quell_samples const& given, Channel const& channel, Frame const& frame) {
    auto const what = "samples of channel '" + channel.name + "'";
    if (given.columns == 0 && given.rows == 0) {
        bool const is_whole = (given.width == 0 && given.height == 0) || (given.width == frame.width && given.height == frame.height);
        if (is_whole) return {};
        return what + ": an image of " + size(given.width, given.height) + " in a frame of " + size(frame.width, frame.height) +
               ", and no block; give 1 to 8 columns and rows";
    }
    if (channel.is_guide) return what + ": a guide must be there for every pixel; give columns and rows 0";
    if (given.columns < 1 || given.columns > 8 || given.rows < 1 || given.rows > 8)
        return what + ": blocks of " + size(given.columns, given.rows) + "; give 1 to 8 columns and rows";
    if (given.phase_x < 0 || given.phase_x >= given.columns || given.phase_y < 0 || given.phase_y >= given.rows)
        return what + ": a phase of " + std::to_string(given.phase_x) + ", " + std::to_string(given.phase_y) +
               "; give the place of a pixel in its block of " + size(given.columns, given.rows);
    auto const up = [](int length, int part) { return (length + part - 1) / part; };
    int const w = frame.width, h = frame.height, most_w = up(w, given.columns), most_h = up(h, given.rows);
    to = {given.columns, given.rows, given.staggered, given.phase_x, given.phase_y, given.width, given.height};
    if (to.width == 0 && to.height == 0) to.width = most_w, to.height = most_h;
    to.side_by_side = to.width != w || to.height != h;
    auto const fits = [](int length, int least, int most) { return length >= 1 && length >= least && length <= most; };
    if (to.side_by_side && !(fits(to.width, w / to.columns, most_w) && fits(to.height, h / to.rows, most_h)))
        return what + ": an image of " + size(to.width, to.height) + " in a frame of " + size(w, h) + "; give " + size(most_w, most_h) +
               ", or the frame's size";
    return {};
}

std::string take_channels(quell_denoiser& denoiser, Frame& to, quell_frame const& frame) {
    auto const& wanted = denoiser.way->channels;
    to.channels.assign(wanted.size(), {});
    auto const all = [&] { return joined(wanted, [](auto const& each) { return each.name; }); };
    if (frame.channels == nullptr && frame.channel_count > 0) return "channels: null; point them at " + all();
    std::vector<bool> there(wanted.size());
    for (std::size_t i = 0; i < frame.channel_count; ++i) {
        auto const& given = frame.channels[i];
        if (given.name == nullptr) return "channels[" + std::to_string(i) + "]: no name (null); name one of " + all();
        auto const* const found = denoiser.channel(given.name);
        auto const what = "channel '" + std::string(given.name) + "'";
        if (found == nullptr) return what + ": '" + denoiser.preset->name + "' has none of that name; it reads " + all();
        auto const index = static_cast<std::size_t>(found - wanted.data());
        if (there[index]) return what + ": it is there twice; give it once";
        there[index] = true;
        if (frame.fractions != nullptr && frame.fractions[i] != 1)
            return what + ": a fraction of " + std::to_string(frame.fractions[i]) + "; give 1: other sizes are not supported yet";
        auto& image = to.channels[index];
        if (frame.samples != nullptr)
            if (auto const wrong = take_samples(image.samples, frame.samples[i], *found, to); !wrong.empty()) return wrong;
        int const width = image.samples.columns > 0 ? image.samples.width : to.width;
        if (auto const wrong = take(image, given.image, what, found->components, width); !wrong.empty()) return wrong;
    }
    for (std::size_t i = 0; i < there.size(); ++i)
        if (!there[i] && !wanted[i].optional)
            return "channel '" + wanted[i].name + "': it is missing; '" + denoiser.preset->name + "' reads " + all();
    return {};
}

std::string take_output(quell_denoiser& denoiser, quell_frame const& frame) {
    int const components = denoiser.way->output_components;
    auto const& sizes = denoiser.sizes;
    if (auto const wrong = take(denoiser.output, frame.output, "output", components, sizes.output_width); !wrong.empty()) return wrong;
    auto const out = range_of(denoiser.output, components, sizes.output_width, sizes.output_height);
    for (auto const& each : denoiser.frames)
        for (std::size_t i = 0; i < denoiser.way->channels.size(); ++i) {
            auto const& channel = denoiser.way->channels[i];
            auto const& image = each.channels[i];
            if (image.data == nullptr) continue;
            bool const is_whole = image.samples.columns == 0;
            auto const in = range_of(image, channel.components, is_whole ? each.width : image.samples.width,
                                     is_whole ? each.height : image.samples.height);
            if (out.begin < in.end && in.begin < out.end)
                return "output: its memory overlaps that of channel '" + channel.name + "'; give it memory of its own";
        }
    return {};
}

std::string take_size(quell_denoiser const& denoiser, Frame& to, quell_frame const& frame) {
    auto const& usual = denoiser.sizes;
    to.width = usual.width, to.height = usual.height;
    if (frame.width == 0 && frame.height == 0) return {};
    auto const what = "frame: a size of " + size(frame.width, frame.height);
    if (!denoiser.resolves && (frame.width != usual.width || frame.height != usual.height))
        return what + "; this denoiser's frames are " + size(usual.width, usual.height) +
               ": leave width and height 0, or let settings.stages have 'resolve', with which frames may be of several sizes";
    if (denoiser.resolves &&
        (frame.width < 1 || frame.height < 1 || !is_ratio({frame.width, frame.height, usual.output_width, usual.output_height})))
        return what + " for an output of " + size(usual.output_width, usual.output_height) +
               "; the output must be 1 to 4 times as wide and as high";
    to.width = frame.width, to.height = frame.height;
    return {};
}

/// A sentence where there is no camera, and must be, or where its jitter can't be.
std::string check_camera(quell_denoiser const& denoiser, quell_camera const* camera) {
    if (camera == nullptr) {
        if (auto const& stage = denoiser.way->needs_jitter; !stage.empty())
            return "frame.camera: null; '" + stage + "' needs its jitter, which may be 0";
        if (denoiser.way->needs_camera) return "frame.camera: null; '" + denoiser.preset->name + "' needs the camera";
        return denoiser.motion.has_jitter != 0 ? "frame.camera: null; settings.motion.has_jitter needs its jitter" : "";
    }
    constexpr float most = 8;
    auto const [x, y] = camera->jitter;
    if (denoiser.way->needs_jitter.empty() || (std::abs(x) <= most && std::abs(y) <= most)) return {};
    return "frame.camera: a jitter of " + std::to_string(x) + ", " + std::to_string(y) +
           "; give the samples' offset from the pixels' centres, in pixels of the frame: at most 8";
}

std::string take_frame(quell_denoiser& denoiser, Frame& to, quell_frame const& frame) {
    if (frame.device != nullptr)
        return "frame.device: it is not null; leave it so: settings.device says what denoises, and with QUELL_CUDA pointers say where "
               "images lie";
    if (auto const wrong = take_size(denoiser, to, frame); !wrong.empty()) return wrong;
    if (auto const wrong = take_channels(denoiser, to, frame); !wrong.empty()) return wrong;
    if (auto const wrong = check_camera(denoiser, frame.camera); !wrong.empty()) return wrong;
    static_assert(sizeof(Camera) == sizeof(quell_camera));
    to.camera = reinterpret_cast<Camera const*>(frame.camera);
    to.number = frame.number, to.has_number = frame.has_number != 0;
    to.shutter = frame.shutter;
    return {};
}

quell_status status_of(Outcome outcome) {
    switch (outcome) {
    case Outcome::ok:
        return QUELL_OK;
    case Outcome::invalid:
        return QUELL_INVALID_ARGUMENT;
    case Outcome::not_supported:
        return QUELL_NOT_SUPPORTED;
    case Outcome::no_memory:
        return QUELL_NO_MEMORY;
    default:
        return QUELL_FAILED;
    }
}

/// Runs a window of frames.
quell_status run(quell_denoiser& denoiser, quell_frame const* frames, std::size_t count) {
    Running const running(denoiser);
    if (!running.first) return fail(QUELL_BUSY, "quell_run: another thread runs this denoiser; make one for each thread");
    denoiser.frames.resize(count);
    auto const* at = reinterpret_cast<std::byte const*>(frames);
    std::string wrong;
    quell_frame first = QUELL_FRAME;
    for (std::size_t i = 0; i < count; ++i, at += frames->struct_size) {
        quell_frame frame = QUELL_FRAME;
        wrong = take_struct(frame, at, "frame", "QUELL_FRAME", offsetof(quell_frame, fractions));
        if (wrong.empty()) wrong = take_frame(denoiser, denoiser.frames[i], frame);
        if (!wrong.empty()) return fail(QUELL_INVALID_ARGUMENT, (count > 1 ? "frames[" + std::to_string(i) + "]: " : "") + wrong);
        if (i == 0) first = frame;
    }
    wrong = take_output(denoiser, first);
    if (!wrong.empty()) return fail(QUELL_INVALID_ARGUMENT, wrong);
    std::string error;
    auto const outcome = denoiser.instance->run(denoiser.frames, denoiser.output, error);
    if (outcome != Outcome::ok) return fail(status_of(outcome), error);
    denoiser.guide_width = denoiser.frames.front().width;
    return QUELL_OK;
}

/// The names of a list between commas; with `resolve` where the output has another size.
std::vector<std::string> stages_of(quell_settings const& settings) {
    auto names = names_in(settings.stages != nullptr ? settings.stages : "");
    if (is_resized(settings) && std::ranges::find(names, resolve_stage) == names.end()) names.emplace_back(resolve_stage);
    return names;
}
/// A sentence where a name is none of those that there are, or there twice.
std::string check_stages(std::vector<std::string> const& names, std::vector<std::string> const& all, bool on_device) {
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (std::ranges::find(all, names[i]) == all.end())
            return "settings.stages: there is no '" + names[i] + (on_device ? "' for CUDA" : "'") + "; give " +
                   (all.empty() ? "none" : "some of these, with commas between: " + joined(all, [](auto const& each) { return each; }));
        if (std::find(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(i), names[i]) - names.begin() <
            static_cast<std::ptrdiff_t>(i))
            return "settings.stages: '" + names[i] + "' is there twice; give it once";
    }
    return {};
}

/// A sentence where the settings are wrong.
std::string check(quell_settings const& settings) {
    if (settings.width < 1 || settings.height < 1)
        return "settings: a size of " + size(settings.width, settings.height) + "; give a width and a height of at least one pixel";
    if (settings.samples_per_pixel < 0)
        return "settings.samples_per_pixel: " + std::to_string(settings.samples_per_pixel) +
               "; give their number, or 0 where that is not known";
    if (settings.threads < 0) return "settings.threads: " + std::to_string(settings.threads) + "; give 0 or more";
    if ((settings.allocate == nullptr) != (settings.release == nullptr))
        return "settings: one of allocate and release is null; give both or none";
    auto const sizes = sizes_of(settings);
    if (!is_ratio(sizes))
        return "settings: an output of " + size(sizes.output_width, sizes.output_height) + " for frames of " +
               size(sizes.width, sizes.height) +
               "; give 1 to 4 times their width and height as output_width and output_height, or 0 and 0 for the frames' own size";
    if (settings.device != QUELL_CPU && settings.device != QUELL_CUDA)
        return "settings.device: " + std::to_string(settings.device) + "; give QUELL_CPU or QUELL_CUDA";
    if (settings.motion.unit < 0 || settings.motion.unit > 2)
        return "settings.motion.unit: " + std::to_string(settings.motion.unit) +
               "; give 0 (pixels), 1 or 2 (the image is 1 or 2 wide and high)";
    return {};
}

} // namespace

char const* quell_version(void) { return QUELL_LIBRARY_VERSION; }
char const* quell_error(void) { return last_error().c_str(); }

char const* quell_preset_name(int32_t index) { return quell_device_preset_name(QUELL_CPU, index); }
char const* quell_device_preset_name(int32_t device, int32_t index) {
    auto const* const codes_there = codes_of(device);
    auto const i = static_cast<std::size_t>(index);
    return codes_there != nullptr && index >= 0 && i < codes_there->presets.size() ? codes_there->presets[i].name.c_str() : nullptr;
}
char const* quell_stage_name(int32_t device, int32_t index) {
    auto const* const codes_there = codes_of(device);
    auto const i = static_cast<std::size_t>(index);
    return codes_there != nullptr && index >= 0 && i < codes_there->stages.size() ? codes_there->stages[i].c_str() : nullptr;
}
char const* quell_instruction_set_name(int32_t index) {
    return index >= 0 && static_cast<std::size_t>(index) < std::size(codes) ? codes[index].name : nullptr;
}

quell_status quell_create(quell_settings const* settings, quell_denoiser** denoiser) {
    return guarded([&]() -> quell_status {
        if (denoiser == nullptr) return fail(QUELL_INVALID_ARGUMENT, "quell_create: `denoiser` is null; point it at a quell_denoiser *");
        *denoiser = nullptr;
        if (settings == nullptr) return fail(QUELL_INVALID_ARGUMENT, "quell_create: `settings` is null; start from QUELL_SETTINGS");
        quell_settings own = QUELL_SETTINGS;
        auto wrong = take_struct(own, reinterpret_cast<std::byte const*>(settings), "settings", "QUELL_SETTINGS", sizeof(quell_settings));
        if (wrong.empty()) wrong = check(own);
        if (!wrong.empty()) return fail(QUELL_INVALID_ARGUMENT, wrong);
        settings = &own;
        quell_status status = QUELL_OK;
        bool const on_device = settings->device != QUELL_CPU;
        if (on_device && cuda_codes() == nullptr)
            return fail(QUELL_NOT_SUPPORTED,
                        std::string("settings.device: QUELL_CUDA, and this library was built without CUDA; ") + build_with_cuda);
        if (on_device) wrong = check_device(*settings);
        if (!wrong.empty()) return fail(QUELL_NOT_SUPPORTED, wrong);
        auto const* const code = on_device ? &cuda_code : code_for(settings->instruction_set, status);
        if (code == nullptr) return status;
        auto const names = stages_of(*settings);
        wrong = check_stages(names, code->all()->stages, on_device);
        if (!wrong.empty()) return fail(on_device ? QUELL_NOT_SUPPORTED : QUELL_INVALID_ARGUMENT, wrong);
        auto const& all = code->all()->presets;
        auto const wanted = std::string(settings->preset != nullptr ? settings->preset : "");
        auto const preset = std::ranges::find(all, wanted, &PresetCode::name);
        if (preset == all.end())
            return fail(QUELL_UNKNOWN_PRESET, "settings.preset: there is no '" + wanted + (on_device ? "' for CUDA" : "'") +
                                                  "; give one of: " + joined(all, [](auto const& each) { return each.name; }));
        auto const way = preset->with(names, settings->alpha != 0, wrong);
        if (way == nullptr) return fail(QUELL_NOT_SUPPORTED, wrong);
        auto const has = [&](auto const* name) { return std::ranges::find(names, name) != names.end(); };
        std::unique_ptr<quell_denoiser> made(new quell_denoiser{.code = code,
                                                                .preset = &*preset,
                                                                .way = way,
                                                                .motion = settings->motion,
                                                                .two_sided = has(two_sided_stage),
                                                                .resolves = has(resolve_stage) && !on_device,
                                                                .sizes = sizes_of(*settings),
                                                                .guide_width = settings->width,
                                                                .threads = OwnThreads(settings->threads),
                                                                .plan = {},
                                                                .instance = {},
                                                                .frames = {},
                                                                .output = {}});
        Parallel parallel = settings->parallel != nullptr
                                ? Parallel{.run = settings->parallel, .user = settings->parallel_user, .threads = settings->threads}
                                : Parallel{.run = OwnThreads::run, .user = &made->threads, .threads = made->threads.count()};
        parallel.stream = settings->stream;
        Memory const memory{settings->allocate, settings->release, settings->memory_user};
        Outcome outcome = Outcome::ok;
        std::string error;
        auto const& given = settings->motion;
        Motion const motion{given.from_previous, given.unit, given.y_up, given.has_jitter};
        auto const samples = static_cast<float>(std::max(settings->samples_per_pixel, 1));
        made->instance = way->make(made->sizes, samples, motion, parallel, memory, outcome, error);
        if (outcome != Outcome::ok) return fail(status_of(outcome), error);
        *denoiser = made.release();
        return QUELL_OK;
    });
}
void quell_destroy(quell_denoiser* denoiser) { delete denoiser; }

int32_t quell_width(quell_denoiser const* denoiser) { return denoiser != nullptr ? denoiser->sizes.width : 0; }
int32_t quell_height(quell_denoiser const* denoiser) { return denoiser != nullptr ? denoiser->sizes.height : 0; }
int32_t quell_output_width(quell_denoiser const* denoiser) { return denoiser != nullptr ? denoiser->sizes.output_width : 0; }
int32_t quell_output_height(quell_denoiser const* denoiser) { return denoiser != nullptr ? denoiser->sizes.output_height : 0; }
char const* quell_channel_name(quell_denoiser const* denoiser, int32_t index) {
    if (denoiser == nullptr || index < 0) return nullptr;
    auto const& all = denoiser->way->channels;
    return static_cast<std::size_t>(index) < all.size() ? all[static_cast<std::size_t>(index)].name.c_str() : nullptr;
}
int32_t quell_channel_components(quell_denoiser const* denoiser, char const* name) {
    auto const* const found = denoiser != nullptr && name != nullptr ? denoiser->channel(name) : nullptr;
    return found != nullptr ? found->components : 0;
}
int32_t quell_channel_is_optional(quell_denoiser const* denoiser, char const* name) {
    auto const* const found = denoiser != nullptr && name != nullptr ? denoiser->channel(name) : nullptr;
    return found != nullptr && found->optional ? 1 : 0;
}
int32_t quell_output_components(quell_denoiser const* denoiser) { return denoiser != nullptr ? denoiser->way->output_components : 0; }
int32_t quell_needs_camera(quell_denoiser const* denoiser) { return denoiser != nullptr && denoiser->way->needs_camera ? 1 : 0; }
char const* quell_guide_name(quell_denoiser const* denoiser, int32_t index) {
    if (denoiser == nullptr || index < 0) return nullptr;
    auto const& all = denoiser->way->guides;
    return static_cast<std::size_t>(index) < all.size() ? all[static_cast<std::size_t>(index)].name.c_str() : nullptr;
}
quell_status quell_copy_guide(quell_denoiser* denoiser, char const* name, quell_image const* image) {
    return guarded([&]() -> quell_status {
        if (denoiser == nullptr || name == nullptr || image == nullptr)
            return fail(QUELL_INVALID_ARGUMENT, "quell_copy_guide: an argument is null; give a denoiser, a name and an image");
        auto const& all = denoiser->way->guides;
        auto const found = std::ranges::find(all, name, &Channel::name);
        if (found == all.end())
            return fail(QUELL_NOT_SUPPORTED, "quell_copy_guide: '" + denoiser->preset->name + "' accumulates no '" + name + "'; " +
                                                 (all.empty() ? "the preset accumulated does"
                                                              : "give one of: " + joined(all, [](auto const& each) { return each.name; })));
        Running const running(*denoiser);
        if (!running.first) return fail(QUELL_BUSY, "quell_copy_guide: another thread runs this denoiser; wait for it");
        Image to;
        if (auto const wrong = take(to, *image, "guide '" + found->name + "'", found->components, denoiser->guide_width); !wrong.empty())
            return fail(QUELL_INVALID_ARGUMENT, wrong);
        std::string error;
        auto const outcome = denoiser->instance->copy_guide(found->name, to, error);
        return outcome == Outcome::ok ? QUELL_OK : fail(status_of(outcome), "quell_copy_guide: " + error);
    });
}
char const* quell_instruction_set(quell_denoiser const* denoiser) { return denoiser != nullptr ? denoiser->code->name : ""; }
char const* quell_plan(quell_denoiser const* denoiser) {
    if (denoiser == nullptr) return "";
    auto& plan = const_cast<quell_denoiser*>(denoiser)->plan;
    guarded([&] {
        if (plan.empty()) plan = denoiser->way->plan();
        return QUELL_OK;
    });
    return plan.c_str();
}

quell_status quell_run(quell_denoiser* denoiser, quell_frame const* frame) {
    return guarded([&]() -> quell_status {
        if (denoiser == nullptr) return fail(QUELL_INVALID_ARGUMENT, "quell_run: `denoiser` is null; make one by quell_create");
        if (frame == nullptr) return fail(QUELL_INVALID_ARGUMENT, "quell_run: `frame` is null; start from QUELL_FRAME");
        return run(*denoiser, frame, 1);
    });
}
quell_status quell_run_two_sided(quell_denoiser* denoiser, quell_frame const* frames, size_t count) {
    return guarded([&]() -> quell_status {
        if (denoiser == nullptr) return fail(QUELL_INVALID_ARGUMENT, "quell_run_two_sided: `denoiser` is null; make one by quell_create");
        if (frames == nullptr || count == 0)
            return fail(QUELL_INVALID_ARGUMENT, "quell_run_two_sided: no frames; give the one to denoise and those after it");
        if (!denoiser->two_sided)
            return fail(QUELL_NOT_SUPPORTED, "quell_run_two_sided: the denoiser was made without 'two-sided' in settings.stages; add it");
        return run(*denoiser, frames, count);
    });
}
quell_status quell_forget(quell_denoiser* denoiser) {
    return guarded([&]() -> quell_status {
        if (denoiser == nullptr) return fail(QUELL_INVALID_ARGUMENT, "quell_forget: `denoiser` is null; make one by quell_create");
        Running const running(*denoiser);
        if (!running.first) return fail(QUELL_BUSY, "quell_forget: another thread runs this denoiser; wait for it");
        denoiser->instance->forget();
        return QUELL_OK;
    });
}
quell_status quell_get_statistics(quell_denoiser const* denoiser, quell_statistics* statistics) {
    return guarded([&]() -> quell_status {
        if (denoiser == nullptr || statistics == nullptr)
            return fail(QUELL_INVALID_ARGUMENT, "quell_get_statistics: an argument is null; give a denoiser and QUELL_STATISTICS");
        quell_statistics own = QUELL_STATISTICS;
        if (auto const wrong = take_struct(own, reinterpret_cast<std::byte const*>(statistics), "statistics", "QUELL_STATISTICS",
                                           sizeof(quell_statistics));
            !wrong.empty())
            return fail(QUELL_INVALID_ARGUMENT, wrong);
        Running const running(*const_cast<quell_denoiser*>(denoiser));
        if (!running.first) return fail(QUELL_BUSY, "quell_get_statistics: another thread runs this denoiser; wait for it");
        auto const counted = denoiser->instance->statistics();
        auto const size = std::min(statistics->struct_size, sizeof(own)); // an earlier version's is shorter
        own = {size, counted.frames, counted.resets, counted.missing_samples, counted.repaired_guides, counted.bytes};
        std::memcpy(statistics, &own, size);
        return QUELL_OK;
    });
}
