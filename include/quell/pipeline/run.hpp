#pragma once

#include <quell/pipeline/execution/frame_run.hpp>
#include <quell/pipeline/wrong_calls.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Denoises one frame. Returns a view of the output, valid until the next run with this history.
///
///     auto clean = run(denoise, frame, history, Threads{});    clean.get(component, x, y)
///
/// @throws Error for channels of the wrong size, missing memory, a shutter that is negative or not finite, and singular cameras where the
/// pipeline needs one
template <class P, class Set, class FrameStorage, class OfHistory, class Storage, Executor E = Simd>
auto run(P const& pipeline, Frame<Set, FrameStorage> const& frame, History<OfHistory, Storage>& history, E const& executor = {}) {
    static_assert(std::is_same_v<P, OfHistory>,
                  "run(pipeline, frame, history): the history is another pipeline's; construct it with this pipeline");
    static_assert(contained_in<typename OfHistory::reads, Set>,
                  "run(pipeline, frame, ...): the frame lacks a channel that the pipeline reads; construct the frame with this pipeline");
    // After a mistake nothing more is said.
    if constexpr (!std::is_same_v<P, OfHistory> || !contained_in<typename OfHistory::reads, Set>)
        return detail::NoOutput{};
    else {
        detail::NoTarget const none;
        return detail::Run<P, Frame<Set, FrameStorage>, History<P, Storage>, E, detail::NoTarget>(pipeline, frame, history, executor, none)
            .all();
    }
}

/// Adds a frame to the history and leaves out the filters after Temporal. Returns a view of the accumulated signal, valid until the next
/// run with this history. For warm-up, and for the later frames of a window (pipeline/two_sided.hpp).
/// @throws Error as run() does
template <class P, class Set, class FrameStorage, class Storage, Executor E = Simd>
auto accumulate(P const& pipeline, Frame<Set, FrameStorage> const& frame, History<P, Storage>& history, E const& executor = {}) {
    static_assert(contained_in<typename P::reads, Set>, "accumulate(pipeline, frame, ...): the frame lacks a channel that the pipeline "
                                                        "reads; construct the frame with this pipeline");
    if constexpr (!contained_in<typename P::reads, Set>)
        return detail::NoOutput{};
    else {
        detail::NoTarget const none;
        return detail::Run<P, Frame<Set, FrameStorage>, History<P, Storage>, E, detail::NoTarget>(pipeline, frame, history, executor, none)
            .accumulated();
    }
}

/// Like run(), but writes the output through a view of the host's: by set(component, x, y, value), from several threads with Threads. What
/// the view does not show, such as alpha, stays as it is.
/// @throws Error as run() does, and for a target that is not of the frame's size
template <class P, class Set, class FrameStorage, class Storage, ImageView Target, Executor E = Simd>
void run_into(Target const& target, P const& pipeline, Frame<Set, FrameStorage> const& frame, History<P, Storage>& history,
              E const& executor = {}) {
    static_assert(contained_in<typename P::reads, Set>, "run_into(target, pipeline, frame, ...): the frame lacks a channel that the "
                                                        "pipeline reads; construct the frame with this pipeline");
    static_assert(Target::components == P::Output::components,
                  "run_into(target, pipeline, frame, ...): the target has another number of components than the pipeline's signal");
    if constexpr (contained_in<typename P::reads, Set> && Target::components == P::Output::components) {
        detail::check_target(target.size, frame.size);
        detail::Run<P, Frame<Set, FrameStorage>, History<P, Storage>, E, Target>(pipeline, frame, history, executor, target).all();
    }
}

} // namespace quell::inline QUELL_INSTRUCTION_SET
