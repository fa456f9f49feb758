// The entry of libquell's code for one instruction set: QUELL_CODE_ENTRY is its name. Compiled presets, behind types that are the same for
// all instruction sets.
#include "compiled_preset.hpp"
#include "convert_motion.hpp"
#include "history_choice.hpp"
#include "resolved_denoiser.hpp"
#include "stage.hpp"

#include <quell/core/error.hpp>

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <utility>

namespace quell_library {

namespace {

Outcome failed(std::string& error, char const* text, Outcome outcome) noexcept {
    try {
        error = text;
    } catch (...) {
        error.clear();
    }
    return outcome;
}
/// Calls f, and says what was thrown.
template <class F> Outcome caught(std::string& error, F&& f) noexcept {
    try {
        f();
        return Outcome::ok;
    } catch (quell::Error const& thrown) {
        return failed(error, thrown.what(), Outcome::invalid);
    } catch (std::bad_alloc const&) {
        return failed(error, "memory: there is no more; give smaller images, or let go of other denoisers", Outcome::no_memory);
    } catch (std::exception const& thrown) {
        return failed(error, thrown.what(), Outcome::failed);
    }
}

class PresetInstance final : public Instance {
    std::shared_ptr<std::vector<ReadChannel> const> channels; // stages refer to them
    quell::MotionConvention motion;
    JitterOf before;         ///< of the frame that was denoised last
    bool has_guides = false; ///< whether the last frame, which was denoised to the end, has some
    std::unique_ptr<CompiledDenoiser> denoiser;
    std::vector<FrameImages> window;

public:
    PresetInstance(std::shared_ptr<std::vector<ReadChannel> const> read, Motion const& m, std::unique_ptr<CompiledDenoiser> made)
        : channels(std::move(read)), motion(convention_of(m)), denoiser(std::move(made)) {}

    Outcome run(std::vector<Frame> const& frames, Image const& output, std::string& error) noexcept override {
        return caught(error, [&] {
            window.resize(frames.size());
            for (std::size_t i = 0; i < frames.size(); ++i) {
                auto& images = window[i];
                take(images, frames[i]);
                JitterOf const now{images.camera.jitter, images.size},
                    then = i > 0 ? JitterOf{window[i - 1].camera.jitter, window[i - 1].size} : before;
                convert_motion(motion, *channels, images.channels, now, then);
            }
            denoise(output);
            before = {window.front().camera.jitter, window.front().size};
        });
    }
    Outcome copy_guide(std::string const& name, Image const& output, std::string& error) noexcept override {
        bool is_there = false;
        auto const outcome = caught(error, [&] { is_there = has_guides && denoiser->copy_guide(name, output); });
        if (is_there || outcome != Outcome::ok) return outcome;
        return failed(error, "no frame has been run, or the last one failed: run one, whose guides are then there", Outcome::invalid);
    }
    void forget() noexcept override { denoiser->forget(); }
    [[nodiscard]] Statistics statistics() const noexcept override {
        auto const counted = denoiser->statistics();
        return {counted.frames, counted.resets, counted.missing_samples, counted.repaired_guides.pixels, denoiser->bytes()};
    }

private:
    /// A frame that is refused leaves the guides as they were. After any other error they may be of this frame, of whose size the caller
    /// knows nothing.
    void denoise(Image const& output) {
        bool const had_guides = std::exchange(has_guides, false);
        try {
            denoiser->run(window, output);
        } catch (quell::Error const&) {
            has_guides = had_guides;
            throw;
        }
        has_guides = true;
    }
    void take(FrameImages& images, Frame const& given) const {
        images.size = {given.width, given.height}, images.channels = given.channels, images.shutter = given.shutter;
        images.number = given.has_number ? std::optional<long long>(given.number) : std::nullopt;
        if (given.camera == nullptr) return; // that of the last frame
        images.camera = {glm::make_mat4(given.camera->view), glm::make_mat4(given.camera->projection),
                         glm::make_vec2(given.camera->jitter)};
    }
};

std::string quoted(std::string const& name) { return "'" + name + "'"; }

/// What a preset is compiled for, with frames after each and with alpha; none where it is not.
Way const& way_of(CompiledPreset const& preset, bool two_sided, bool alpha) {
    return alpha ? preset.two_sided_alpha : two_sided ? preset.two_sided : preset.usual;
}

std::shared_ptr<PresetWay const> with_stages(CompiledPreset const& preset, std::vector<std::string> const& names, bool alpha,
                                             std::string& refusal) {
    auto const is_wanted = [&](std::string_view name) { return std::ranges::find(names, name) != names.end(); };
    bool const two_sided = is_wanted(two_sided_stage);
    auto const& way = way_of(preset, two_sided, alpha);
    auto const refuse = [&](std::string const& subject, std::string const& why) {
        refusal = subject + ": " + quoted(preset.name) + " " + why;
        return nullptr;
    };
    if (!way && alpha) return refuse("settings.alpha", "has none; leave it 0, or take general or final-frame");
    if (!way) return refuse("settings.stages", "makes no use of frames to come; leave 'two-sided' out, or take general or final-frame");
    auto const& judge = way_of(judge_of(preset), two_sided, alpha);
    if (is_wanted(resolve_stage) && is_wanted(colours_stage)) return refuse("settings.stages", colours_and_resolve);
    std::vector<Stage const*> wanted;
    auto plan = way.plan();
    for (auto const& stage : stages()) {
        if (!is_wanted(stage.name)) continue;
        if (auto const why = stage.refusal(way); !why.empty())
            return refuse("settings.stages", why + "; leave " + quoted(stage.name) + " out");
        if (two_sided && stage.takes_one_frame)
            return refuse("settings.stages", "uses frames to come with 'two-sided', and " + quoted(stage.name) +
                                                 " is made of frames that are past; leave one of the two out");
        wanted.push_back(&stage);
        plan = stage.plan(plan, way, judge);
    }
    bool const resolves = is_wanted(resolve_stage);
    auto channels = std::make_shared<std::vector<ReadChannel> const>(resolves ? channels_of_resolved(way) : way.channels);
    auto const jittered = std::ranges::find_if(wanted, &Stage::needs_jitter);
    PresetWay code{.output_components = way.output_components,
                   .needs_camera = way.needs_camera || jittered != wanted.end(),
                   .needs_jitter = jittered != wanted.end() ? (*jittered)->name : ""};
    for (auto const& channel : *channels) code.channels.push_back({channel.name, channel.components, channel.optional, channel.is_guide});
    for (auto const& guide : way.guides) code.guides.push_back({guide.name, guide.components});
    code.plan = [plan] { return plan; };
    bool const is_judged = is_wanted(evidence_stage);
    code.make = [=, &way, &judge](Sizes const& sizes, float samples, Motion const& motion, Parallel const& parallel, Memory const& memory,
                                  Outcome& outcome, std::string& error) {
        std::unique_ptr<Instance> made;
        outcome = caught(error, [&] {
            StagePlace const place{.way = way,
                                   .judge = judge,
                                   .channels = *channels,
                                   .size = {sizes.width, sizes.height},
                                   .output = {sizes.output_width, sizes.output_height},
                                   .samples = samples,
                                   .is_judged = is_judged,
                                   .parallel = parallel,
                                   .memory = memory};
            auto denoiser = way.make(place.size, parallel, memory);
            for (auto const* stage : wanted) denoiser = stage->put(std::move(denoiser), place);
            made = std::make_unique<PresetInstance>(channels, motion, std::move(denoiser));
        });
        return made;
    };
    return std::make_shared<PresetWay const>(std::move(code));
}

Codes all_codes() {
    Codes all;
    for (auto const& preset : compiled_presets())
        all.presets.push_back({preset.name, [&preset](std::vector<std::string> const& names, bool alpha, std::string& refusal) {
                                   return with_stages(preset, names, alpha, refusal);
                               }});
    all.stages.emplace_back(two_sided_stage);
    for (auto const& stage : stages()) all.stages.push_back(stage.name);
    return all;
}

} // namespace

} // namespace quell_library

extern "C" quell_library::CodesOf QUELL_CODE_ENTRY;
extern "C" quell_library::Codes const* QUELL_CODE_ENTRY() {
    static quell_library::Codes const all = quell_library::all_codes();
    return &all;
}
