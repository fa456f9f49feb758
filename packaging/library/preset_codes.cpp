// The entry of libquell's code for one instruction set: QUELL_CODE_ENTRY is its name. Compiled presets, behind types that are the same for
// all instruction sets.
#include "compiled_preset.hpp"
#include "convert_motion.hpp"
#include "given_back.hpp"
#include "history_choice.hpp"
#include "resolved_denoiser.hpp"
#include "steady_denoiser.hpp"

#include <quell/core/error.hpp>

#include <glm/gtc/type_ptr.hpp>

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
    std::vector<ReadChannel> const& channels;
    quell::MotionConvention motion;
    JitterOf before;         ///< of the frame that was denoised last
    bool has_guides = false; ///< whether the last frame, which was denoised to the end, has some
    std::unique_ptr<CompiledDenoiser> denoiser;
    std::vector<FrameImages> window;

public:
    PresetInstance(std::vector<ReadChannel> const& read, Motion const& m, std::unique_ptr<CompiledDenoiser> made)
        : channels(read), motion(convention_of(m)), denoiser(std::move(made)) {}

    Outcome run(std::vector<Frame> const& frames, Image const& output, std::string& error) noexcept override {
        return caught(error, [&] {
            window.resize(frames.size());
            for (std::size_t i = 0; i < frames.size(); ++i) {
                auto& images = window[i];
                take(images, frames[i]);
                JitterOf const now{images.camera.jitter, images.size},
                    then = i > 0 ? JitterOf{window[i - 1].camera.jitter, window[i - 1].size} : before;
                convert_motion(motion, channels, images.channels, now, then);
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

/// @param judge of the preset that judges its history
/// @param put_behind makes another denoiser of what the way makes: put_behind(denoiser, sizes, parallel, memory)
PresetWay way_of(Way const& way, Way const& judge, std::vector<ReadChannel> const& channels, auto put_behind) {
    PresetWay code{.output_components = way.output_components, .needs_camera = way.needs_camera, .plan = way.plan};
    for (auto const& channel : channels) code.channels.push_back({channel.name, channel.components, channel.optional, channel.is_guide});
    for (auto const& guide : way.guides) code.guides.push_back({guide.name, guide.components});
    if (can_choose_history(way)) code.plan_of_choice = [&way, &judge] { return plan_of_choice(way, judge); };
    if (can_give_back(way)) code.plan_of_given_back = plan_of_given_back;
    code.make = [read = channels, put_behind, &way, &judge](Sizes const& sizes, Additions const& with, Motion const& motion,
                                                            Parallel const& parallel, Memory const& memory, Outcome& outcome,
                                                            std::string& error) {
        std::unique_ptr<Instance> made;
        outcome = caught(error, [&] {
            quell::Extent const size{sizes.width, sizes.height};
            auto denoiser = way.make(size, parallel, memory);
            bool const is_judged = with.choose_history != 0;
            if (is_judged) {
                auto choice = make_history_choice(way, judge, size, parallel, memory);
                choice->tell_samples(static_cast<float>(with.choose_history));
                denoiser = with_history_choice(std::move(denoiser), std::move(choice));
            }
            if (with.give_back != 0)
                denoiser =
                    with_light_given_back(std::move(denoiser), way, is_judged, static_cast<float>(with.give_back), size, parallel, memory);
            denoiser = put_behind(std::move(denoiser), sizes, parallel, memory);
            if (SteadyChoice const steady{(with.steady_guides & 1) != 0, (with.steady_guides & 2) != 0})
                denoiser = with_steady_guides(std::move(denoiser), read, steady, size, parallel, memory);
            made = std::make_unique<PresetInstance>(read, motion, std::move(denoiser));
        });
        return made;
    };
    return code;
}
PresetWay way_of(Way const& way, Way const& judge) {
    using Made = std::unique_ptr<CompiledDenoiser>;
    auto code = way_of(way, judge, way.channels, [](Made made, Sizes const&, Parallel const&, Memory const&) { return made; });
    if (!can_resolve(way)) return code;
    auto const resolve = [&way](Made made, Sizes const& sizes, Parallel const& parallel, Memory const& memory) {
        return make_resolved(std::move(made), way, {sizes.width, sizes.height}, {sizes.output_width, sizes.output_height}, parallel,
                             memory);
    };
    auto resolved = way_of(way, judge, channels_of_resolved(way), resolve);
    resolved.needs_camera = true, resolved.plan = [&way] { return plan_of_resolved(way); };
    code.resolved = std::make_shared<PresetWay const>(std::move(resolved));
    return code;
}

std::vector<PresetCode> all_codes() {
    std::vector<PresetCode> all;
    for (auto const& preset : compiled_presets()) {
        auto const& judge = judge_of(preset);
        all.push_back({.name = preset.name, .usual = way_of(preset.usual, judge.usual)});
        if (preset.two_sided) all.back().two_sided = way_of(preset.two_sided, judge.two_sided);
        if (preset.two_sided_alpha) all.back().two_sided_alpha = way_of(preset.two_sided_alpha, judge.two_sided_alpha);
    }
    return all;
}

} // namespace

} // namespace quell_library

extern "C" quell_library::PresetCodes QUELL_CODE_ENTRY;
extern "C" std::vector<quell_library::PresetCode> const* QUELL_CODE_ENTRY() {
    static std::vector<quell_library::PresetCode> const all = quell_library::all_codes();
    return &all;
}
