#pragma once

#include <quell/link/colours/anti_aliased.hpp>
#include <quell/pipeline/composite.hpp>
#include <quell/pipeline/unfinished.hpp>
#include <quell/pipeline/window.hpp>
#include <quell/resolve/resolved_history.hpp>

#include <array>
#include <cstddef>

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {
/// Whether a picture has no jitter left: anti-aliased colours are of the pixels' centres.
template <class P> inline constexpr bool has_centred_colours = false;
template <class First, class... Links>
inline constexpr bool has_centred_colours<Chain<First, Links...>> = has_centred_colours<First> ||
                                                                    (Links::keeps::template has<SeenColour> || ...);
} // namespace detail

/// A pipeline, or a Composite, whose output is then anti-aliased over time, at the frame's size or a larger one:
///
///     constexpr auto upscaled = presets::resolve(presets::general(radiance, Demodulate{})); // a Resolved
///     Frame frame{{960, 540}, upscaled};
///     History history{{1920, 1080}, upscaled};           // of the output's size
///     auto const picture = run(upscaled, frame, history);
///
/// Frames may be of any size, which may change from frame to frame: what was resolved stays, and the pipeline's own history begins anew.
/// The host moves its samples within the pixel from frame to frame (frame.camera.jitter): at twice the width and height, over 8 places or
/// more. Without jitter and without motion, the output is a Catmull-Rom interpolation of the input.
/// @tparam P      a Pipeline or Composite
/// @tparam Policy Resolve<...>
template <class P, class Policy = Resolve<>> struct Resolved {
    static_assert(detail::is_pipeline<P>, "Resolved{pipeline, resolve}: the first must be a Pipeline or a Composite");
    static_assert(!detail::has_centred_colours<P>,
                  "Resolved{pipeline, resolve}: colours of that pipeline are anti-aliased already; take one of "
                  "presets::resolve and presets::anti_aliased");
    using Output = typename P::Output;                                          ///< the channel of the picture
    using reads = decltype(typename P::reads{} | Channels<Motion, Depth>{});    ///< channels that the host must supply
    static constexpr MotionConvention motion_convention = P::motion_convention; ///< what the host's motion vectors mean: see Supplied
    static constexpr bool needs_camera = P::needs_camera; ///< whether frame.camera must be set; its jitter is used anyway

    P pipeline;       ///< runs first
    Policy resolve{}; ///< runs on its output

    /// @param p the pipeline
    /// @param r Resolve{...}
    constexpr explicit Resolved(P const& p, Policy const& r = {}) : pipeline(p), resolve(r) {}
};

namespace detail {
struct ResolvedRun {
    /// Runs the pipeline, then the resolve. Returns a view of the output; that is `target`, if it isn't NoTarget.
    /// @param given a frame, or a window
    template <class P, class Policy, class Given, class Storage, class E, class Target>
    static auto all(Resolved<P, Policy> const& resolved, Given& given, History<Resolved<P, Policy>, Storage>& history, E const& executor,
                    Target const& target) {
        auto const& frame = first_frame(given);
        check_frame<Resolved<P, Policy>>(frame);
        before_picture(frame, history);
        Unfinished unfinished(history);
        auto const picture = run(resolved.pipeline, given, history.pipeline, executor);
        auto const output = of_picture(picture, resolved, frame, history, executor, target);
        unfinished.finish();
        return output;
    }
    static auto& of_pipeline(auto& history) { return history.pipeline; }
    /// Before the pipeline runs, whose errors begin the history anew.
    template <class P, class Policy, class Storage>
    static void before_picture(auto const& frame, History<Resolved<P, Policy>, Storage>& history) {
        check_jitter(frame.camera.jitter);
        history.frames.start(frame.number);
    }
    /// Resolves what the pipeline, or somebody else, has made of a frame.
    template <class P, class Policy, class Storage, class Target>
    static auto of_picture(auto const& picture, Resolved<P, Policy> const& resolved, auto const& frame,
                           History<Resolved<P, Policy>, Storage>& history, auto const& executor, Target const& target) {
        auto const& policies = resolved.resolve;
        constexpr bool sharpens = !std::is_same_v<std::remove_cvref_t<decltype(policies.sharpening)>, NoSharpening>,
                       has_target = !std::is_same_v<Target, NoTarget>;
        // First what may fail for want of memory: passes in a queue are those of a whole frame.
        auto const past = history.frames.before();
        auto const& kept = begin(history, frame);
        auto const output = [&] {
            if constexpr (!has_target || sharpens) {
                if (!history.output) history.output.emplace(history.extent);
                return history.output->view();
            } else
                return target;
        }();
        auto const sharpened = [&] {
            if constexpr (!sharpens)
                return output;
            else if constexpr (has_target)
                return target;
            else {
                if (!history.sharpened) history.sharpened.emplace(history.extent);
                return history.sharpened->view();
            }
        }();
        auto const now = kept.view();
        auto const jitter_then = (past.empty() ? kept : *past[0]).jitter_at(frame.size);
        auto const around = history.scratch->view();
        VectorConversion<P::motion_convention> const vectors(frame.size, kept.jitter, jitter_then);
        run_or_enqueue(executor, Region{0, 0, frame.size.width, frame.size.height},
                       KeepFrame{policies, vectors, picture, frame[depth].view(), frame[motion].view(), now, around});

        std::array<std::remove_const_t<decltype(now)>, std::size_t{Policy::past_frames + 1}> frames;
        frames.fill(now);
        std::transform(past.begin(), past.end(), frames.begin() + 1, [](auto const& each) { return each->view(); });
        Region const everywhere{0, 0, history.extent.width, history.extent.height};
        run_or_enqueue(executor, everywhere, ResolveJob{policies, frames, static_cast<int>(past.size()) + 1, around, output});
        if constexpr (sharpens) run_or_enqueue(executor, everywhere, SharpenJob{policies.sharpening, output, sharpened});
        submit_queue(executor);
        history.frames.finish();
        return sharpened;
    }

private:
    /// Makes place for a frame.
    static auto const& begin(auto& history, auto const& frame) {
        if (!history.scratch || !(history.scratch->low.size() == frame.size)) history.scratch.emplace(frame.size);
        auto& kept = history.frames.place();
        if (!kept || !(kept->colour.size() == frame.size)) kept.emplace(frame.size);
        kept->jitter = frame.camera.jitter;
        return *kept;
    }
};
} // namespace detail

namespace detail {
template <class P, class Policy> struct RunOf<Resolved<P, Policy>> : ResolvedRun {};
template <class P, class Policy> inline constexpr int kept_frames_of<Resolved<P, Policy>> = Policy::past_frames;
template <class P, class Policy> struct PassesOf<Resolved<P, Policy>> {
    static void append(auto& passes, Resolved<P, Policy> const& resolved, auto& history) {
        PassesOf<P>::append(passes, resolved.pipeline, ResolvedRun::of_pipeline(history));
        auto const picture = passes.back().denoises;
        passes.push_back({.name = "prepare resolve",
                          .denoises = picture,
                          .farthest_tap = 1,
                          .reads = {"output", Motion::name, Depth::name},
                          .writes = {"picture", Motion::name, Depth::name, "ranges"},
                          .keeps = {"picture", Motion::name, Depth::name}});
        passes.push_back({.name = "resolve",
                          .denoises = picture,
                          .farthest_tap = anywhere,
                          .reads = {"picture", Motion::name, Depth::name, "ranges"},
                          .reads_past = {"picture", Motion::name, Depth::name},
                          .writes = {"output"}});
        if constexpr (!std::is_same_v<std::remove_cvref_t<decltype(resolved.resolve.sharpening)>, NoSharpening>)
            passes.push_back({.name = "sharpen", .denoises = picture, .farthest_tap = 1, .reads = {"output"}, .writes = {"output"}});
    }
};
} // namespace detail

/// Denoises one frame and resolves it. Returns a view of the output, valid until the next run with this history.
/// @param resolved the pipeline and its resolve
/// @param frame of any size; its camera's jitter says where its samples lie
/// @param history of the output's size
/// @param executor as that of run() of a Pipeline
/// @throws Error as run() of a Pipeline does, and for a jitter of more than 8 pixels or one that is not finite
template <class P, class Policy, class Set, class FrameStorage, class Storage, Executor E = Simd>
auto run(Resolved<P, Policy> const& resolved, Frame<Set, FrameStorage> const& frame, History<Resolved<P, Policy>, Storage>& history,
         E const& executor = {}) {
    static_assert(contained_in<typename Resolved<P, Policy>::reads, Set>,
                  "run(resolved, frame, ...): the frame lacks a channel that the pipeline or the resolve reads (motion, depth); construct "
                  "the frame with this Resolved");
    if constexpr (!contained_in<typename Resolved<P, Policy>::reads, Set>)
        return detail::NoOutput{};
    else
        return detail::ResolvedRun::all(resolved, frame, history, executor, detail::NoTarget{});
}

/// Like run(), but writes the output through a view of the host's, as run_into() of a Pipeline does.
/// @param target   where the output goes
/// @param resolved the pipeline and its resolve
/// @param frame    as for run()
/// @param history  as for run()
/// @param executor as for run()
/// @throws Error as run() does, and for a target that is not of the history's size
template <class P, class Policy, class Set, class FrameStorage, class Storage, ImageView Target, Executor E = Simd>
void run_into(Target const& target, Resolved<P, Policy> const& resolved, Frame<Set, FrameStorage> const& frame,
              History<Resolved<P, Policy>, Storage>& history, E const& executor = {}) {
    static_assert(contained_in<typename Resolved<P, Policy>::reads, Set>,
                  "run_into(target, resolved, frame, ...): the frame lacks a channel that the pipeline or the resolve reads (motion, "
                  "depth); construct the frame with this Resolved");
    static_assert(Target::components == P::Output::components,
                  "run_into(target, resolved, frame, ...): the target has another number of components than the pipeline's output");
    if constexpr (contained_in<typename Resolved<P, Policy>::reads, Set> && Target::components == P::Output::components) {
        if (!(target.size == history.size()))
            raise_error<Failure>("run_into: the target", to_string(target.size) + " for a history of " + to_string(history.size()),
                                 "give it the history's size, which is the output's");
        detail::ResolvedRun::all(resolved, frame, history, executor, target);
    }
}

} // namespace quell::inline QUELL_INSTRUCTION_SET
