// The functions of quell.h. Compiled for the oldest machine, without any header of quell's.
#define QUELL_CALL __attribute__((visibility("default")))
#include "quell.h"

#include "own_threads.hpp"
#include "preset_code.hpp"

#include <dispatch/machine_runs.hpp>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <new>

extern "C" quell_library::PresetCodes QUELL_ENTRIES;

namespace {

using namespace quell_library;

/// Code for one instruction set.
struct Code {
    char const* name;
    PresetCodes* presets;
    bool runs_anywhere; ///< it is for the machine that it was built on
};
constexpr Code codes[] = {QUELL_CODES}; // the best first

bool runs_here(Code const& code) { return code.runs_anywhere || machine_runs(code.name); }

std::string& last_error() {
    static thread_local std::string text;
    return text;
}
quell_status fail(quell_status status, std::string const& sentence) {
    last_error() = sentence;
    return status;
}
/// Calls f, which may run out of memory.
template <class F> quell_status guarded(F&& f) noexcept {
    try {
        last_error().clear();
        return f();
    } catch (std::bad_alloc const&) {
        return QUELL_NO_MEMORY; // no memory for a sentence either
    } catch (std::exception const& thrown) {
        try {
            return fail(QUELL_FAILED, thrown.what());
        } catch (...) {
            return QUELL_FAILED;
        }
    }
}

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
    int width, height;
    OwnThreads threads;
    std::string plan;
    std::unique_ptr<Instance> instance;
    std::atomic<bool> busy = false;
    Frame frame;

    [[nodiscard]] std::string size() const { return std::to_string(width) + "x" + std::to_string(height); }
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

/// Takes an image of the caller's; a sentence where it can't be.
std::string take(Image& image, quell_image const& given, std::string const& what, int components, quell_denoiser const& denoiser) {
    if (given.data == nullptr) return what + ": no memory (null); point it at its pixels";
    if (given.format != QUELL_FLOAT32 && given.format != QUELL_FLOAT16)
        return what + ": format " + std::to_string(given.format) + "; give QUELL_FLOAT32 or QUELL_FLOAT16";
    if (given.components < components)
        return what + ": " + std::to_string(given.components) + " components; it has " + std::to_string(components);
    image.is_half = given.format == QUELL_FLOAT16;
    std::ptrdiff_t const element = image.is_half ? 2 : 4;
    image.data = static_cast<std::byte*>(given.data);
    image.component_stride = given.component_stride != 0 ? given.component_stride : element;
    image.pixel_stride = given.pixel_stride != 0 ? given.pixel_stride : element * given.components;
    image.row_stride = given.row_stride != 0 ? given.row_stride : image.pixel_stride * denoiser.width;
    for (auto const stride : {image.component_stride, image.pixel_stride, image.row_stride})
        if (stride % element != 0)
            return what + ": a stride of " + std::to_string(stride) + " bytes; give a multiple of " + std::to_string(element) +
                   ", the size of a component";
    if (reinterpret_cast<std::uintptr_t>(image.data) % static_cast<std::uintptr_t>(element) != 0)
        return what + ": its memory is not aligned to " + std::to_string(element) + " bytes, the size of a component; align it";
    return {};
}

std::string take_channels(quell_denoiser& denoiser, quell_frame const& frame) {
    auto const& wanted = denoiser.preset->channels;
    auto const all = [&] { return joined(wanted, [](auto const& each) { return each.name; }); };
    if (frame.channels == nullptr && frame.channel_count > 0) return "channels: null; point them at " + all();
    std::vector<bool> there(wanted.size());
    for (std::size_t i = 0; i < frame.channel_count; ++i) {
        auto const& given = frame.channels[i];
        if (given.name == nullptr) return "channels[" + std::to_string(i) + "]: no name (null); name one of " + all();
        auto const found = std::ranges::find(wanted, std::string_view(given.name), &Channel::name);
        auto const what = "channel '" + std::string(given.name) + "'";
        if (found == wanted.end()) return what + ": '" + denoiser.preset->name + "' has none of that name; it reads " + all();
        auto const index = static_cast<std::size_t>(found - wanted.begin());
        if (there[index]) return what + ": it is there twice; give it once";
        there[index] = true;
        if (auto const wrong = take(denoiser.frame.channels[index], given.image, what, found->components, denoiser); !wrong.empty())
            return wrong;
    }
    for (std::size_t i = 0; i < there.size(); ++i)
        if (!there[i]) return "channel '" + wanted[i].name + "': it is missing; '" + denoiser.preset->name + "' reads " + all();
    return {};
}

std::string take_output(quell_denoiser& denoiser, quell_frame const& frame) {
    int const components = denoiser.preset->output_components;
    if (auto const wrong = take(denoiser.frame.output, frame.output, "output", components, denoiser); !wrong.empty()) return wrong;
    auto const out = range_of(denoiser.frame.output, components, denoiser.width, denoiser.height);
    for (std::size_t i = 0; i < denoiser.preset->channels.size(); ++i) {
        auto const& channel = denoiser.preset->channels[i];
        auto const in = range_of(denoiser.frame.channels[i], channel.components, denoiser.width, denoiser.height);
        if (out.begin < in.end && in.begin < out.end)
            return "output: its memory overlaps that of channel '" + channel.name + "'; give it memory of its own";
    }
    return {};
}

std::string take_frame(quell_denoiser& denoiser, quell_frame const& frame) {
    if (frame.struct_size != sizeof(quell_frame))
        return "frame.struct_size: " + std::to_string(frame.struct_size) + "; start from QUELL_FRAME of this library's quell.h";
    if (frame.device != nullptr) return "frame.device: device memory is not supported yet; leave it null and give host memory";
    if (auto const wrong = take_channels(denoiser, frame); !wrong.empty()) return wrong;
    if (auto const wrong = take_output(denoiser, frame); !wrong.empty()) return wrong;
    if (denoiser.preset->needs_camera && frame.camera == nullptr)
        return "frame.camera: null; '" + denoiser.preset->name + "' needs the camera";
    static_assert(sizeof(Camera) == sizeof(quell_camera));
    denoiser.frame.camera = reinterpret_cast<Camera const*>(frame.camera);
    denoiser.frame.number = frame.number, denoiser.frame.has_number = frame.has_number != 0;
    denoiser.frame.shutter = frame.shutter;
    return {};
}

quell_status status_of(Outcome outcome) {
    switch (outcome) {
    case Outcome::ok:
        return QUELL_OK;
    case Outcome::invalid:
        return QUELL_INVALID_ARGUMENT;
    case Outcome::no_memory:
        return QUELL_NO_MEMORY;
    default:
        return QUELL_FAILED;
    }
}

/// Null, and a sentence, where the settings are wrong.
std::string check(quell_settings const& settings) {
    if (settings.struct_size != sizeof(quell_settings))
        return "settings.struct_size: " + std::to_string(settings.struct_size) + "; start from QUELL_SETTINGS of this library's quell.h";
    if (settings.width < 1 || settings.height < 1)
        return "settings: a size of " + std::to_string(settings.width) + "x" + std::to_string(settings.height) +
               "; give a width and a height of at least one pixel";
    if (settings.threads < 0) return "settings.threads: " + std::to_string(settings.threads) + "; give 0 or more";
    if ((settings.allocate == nullptr) != (settings.release == nullptr))
        return "settings: one of allocate and release is null; give both or none";
    return {};
}

} // namespace

char const* quell_version(void) { return QUELL_LIBRARY_VERSION; }
char const* quell_error(void) { return last_error().c_str(); }

char const* quell_preset_name(int32_t index) {
    auto const* const code = std::ranges::find_if(codes, runs_here);
    if (code == std::end(codes) || index < 0) return nullptr;
    auto const& all = code->presets();
    return static_cast<std::size_t>(index) < all.size() ? all[static_cast<std::size_t>(index)].name.c_str() : nullptr;
}
char const* quell_instruction_set_name(int32_t index) {
    return index >= 0 && static_cast<std::size_t>(index) < std::size(codes) ? codes[index].name : nullptr;
}

quell_status quell_create(quell_settings const* settings, quell_denoiser** denoiser) {
    return guarded([&]() -> quell_status {
        if (denoiser == nullptr) return fail(QUELL_INVALID_ARGUMENT, "quell_create: `denoiser` is null; point it at a quell_denoiser *");
        *denoiser = nullptr;
        if (settings == nullptr) return fail(QUELL_INVALID_ARGUMENT, "quell_create: `settings` is null; start from QUELL_SETTINGS");
        if (auto const wrong = check(*settings); !wrong.empty()) return fail(QUELL_INVALID_ARGUMENT, wrong);
        quell_status status = QUELL_OK;
        auto const* const code = code_for(settings->instruction_set, status);
        if (code == nullptr) return status;
        auto const& all = code->presets();
        auto const wanted = std::string(settings->preset != nullptr ? settings->preset : "");
        auto const preset = std::ranges::find(all, wanted, &PresetCode::name);
        if (preset == all.end())
            return fail(QUELL_UNKNOWN_PRESET, "settings.preset: there is no '" + wanted +
                                                  "'; give one of: " + joined(all, [](auto const& each) { return each.name; }));
        std::unique_ptr<quell_denoiser> made(new quell_denoiser{.code = code,
                                                                .preset = &*preset,
                                                                .width = settings->width,
                                                                .height = settings->height,
                                                                .threads = OwnThreads(settings->threads),
                                                                .plan = {},
                                                                .instance = {},
                                                                .frame = {}});
        made->frame.channels.resize(preset->channels.size());
        Parallel const parallel = settings->parallel != nullptr ? Parallel{settings->parallel, settings->parallel_user}
                                                                : Parallel{OwnThreads::run, &made->threads};
        Memory const memory{settings->allocate, settings->release, settings->memory_user};
        Outcome outcome = Outcome::ok;
        std::string error;
        made->instance = preset->make(settings->width, settings->height, parallel, memory, outcome, error);
        if (outcome != Outcome::ok) return fail(status_of(outcome), error);
        *denoiser = made.release();
        return QUELL_OK;
    });
}
void quell_destroy(quell_denoiser* denoiser) { delete denoiser; }

char const* quell_channel_name(quell_denoiser const* denoiser, int32_t index) {
    if (denoiser == nullptr || index < 0) return nullptr;
    auto const& all = denoiser->preset->channels;
    return static_cast<std::size_t>(index) < all.size() ? all[static_cast<std::size_t>(index)].name.c_str() : nullptr;
}
int32_t quell_channel_components(quell_denoiser const* denoiser, char const* name) {
    if (denoiser == nullptr || name == nullptr) return 0;
    auto const& all = denoiser->preset->channels;
    auto const found = std::ranges::find(all, std::string_view(name), &Channel::name);
    return found != all.end() ? found->components : 0;
}
int32_t quell_output_components(quell_denoiser const* denoiser) { return denoiser != nullptr ? denoiser->preset->output_components : 0; }
int32_t quell_needs_camera(quell_denoiser const* denoiser) { return denoiser != nullptr && denoiser->preset->needs_camera ? 1 : 0; }
char const* quell_instruction_set(quell_denoiser const* denoiser) { return denoiser != nullptr ? denoiser->code->name : ""; }
char const* quell_plan(quell_denoiser const* denoiser) {
    if (denoiser == nullptr) return "";
    auto& plan = const_cast<quell_denoiser*>(denoiser)->plan;
    guarded([&] {
        if (plan.empty()) plan = denoiser->preset->plan();
        return QUELL_OK;
    });
    return plan.c_str();
}

quell_status quell_run(quell_denoiser* denoiser, quell_frame const* frame) {
    return guarded([&]() -> quell_status {
        if (denoiser == nullptr) return fail(QUELL_INVALID_ARGUMENT, "quell_run: `denoiser` is null; make one by quell_create");
        if (frame == nullptr) return fail(QUELL_INVALID_ARGUMENT, "quell_run: `frame` is null; start from QUELL_FRAME");
        Running const running(*denoiser);
        if (!running.first) return fail(QUELL_BUSY, "quell_run: another thread runs this denoiser; make one for each thread");
        if (auto const wrong = take_frame(*denoiser, *frame); !wrong.empty()) return fail(QUELL_INVALID_ARGUMENT, wrong);
        std::string error;
        auto const outcome = denoiser->instance->run(denoiser->frame, error);
        return outcome == Outcome::ok ? QUELL_OK : fail(status_of(outcome), error);
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
        if (statistics->struct_size != sizeof(quell_statistics))
            return fail(QUELL_INVALID_ARGUMENT, "statistics.struct_size: " + std::to_string(statistics->struct_size) +
                                                    "; start from QUELL_STATISTICS of this library's quell.h");
        auto const counted = denoiser->instance->statistics();
        *statistics = {sizeof(quell_statistics), counted.frames,          counted.resets,
                       counted.missing_samples,  counted.repaired_guides, counted.bytes};
        return QUELL_OK;
    });
}
