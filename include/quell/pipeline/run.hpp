#pragma once

#include <quell/pipeline/execution/frame_run.hpp>

namespace quell {

/// Denoises one frame. Returns a view of the output, which stays valid until the history's next run:
///     auto clean = run(denoise, frame, history, Threads{});    clean.get(component, x, y)
/// @throws Error for images whose sizes differ, memory that is missing, and cameras that a motion source needs and that are singular
template <class P, class Set, class FrameStorage, class Storage, Executor E = Simd>
auto run(P const& pipeline, Frame<Set, FrameStorage> const& frame, History<P, Storage>& history, E const& executor = {}) {
    static_assert(contained_in<typename P::reads, Set>,
                  "run(pipeline, frame, ...): the frame lacks a channel that the pipeline reads; construct the frame with this pipeline");
    detail::NoTarget const none;
    return detail::Run<P, Frame<Set, FrameStorage>, History<P, Storage>, E, detail::NoTarget>(pipeline, frame, history, executor, none)
        .all();
}

/// Adds a frame to the history and does no more: the filters behind Temporal are left out. Returns a view of what the history then shows,
/// which stays valid until the history's next run. For frames that serve others: those of a warm-up, those after the one that is wanted
/// (pipeline/two_sided.hpp).
/// @throws Error as run() does
template <class P, class Set, class FrameStorage, class Storage, Executor E = Simd>
auto accumulate(P const& pipeline, Frame<Set, FrameStorage> const& frame, History<P, Storage>& history, E const& executor = {}) {
    static_assert(contained_in<typename P::reads, Set>, "accumulate(pipeline, frame, ...): the frame lacks a channel that the pipeline "
                                                        "reads; construct the frame with this pipeline");
    detail::NoTarget const none;
    return detail::Run<P, Frame<Set, FrameStorage>, History<P, Storage>, E, detail::NoTarget>(pipeline, frame, history, executor, none)
        .accumulated();
}

/// run(), writing the output through a view of the host's own.
/// @throws Error as run() does, and for a target of another size
template <class P, class Set, class FrameStorage, class Storage, ImageView Target, Executor E = Simd>
void run_into(Target const& target, P const& pipeline, Frame<Set, FrameStorage> const& frame, History<P, Storage>& history,
              E const& executor = {}) {
    static_assert(contained_in<typename P::reads, Set>, "run_into(target, pipeline, frame, ...): the frame lacks a channel that the "
                                                        "pipeline reads; construct the frame with this pipeline");
    static_assert(Target::components == P::Output::components,
                  "run_into(target, pipeline, frame, ...): the target has another number of components than the pipeline's signal");
    if (!(target.size == frame.size))
        throw Error("run_into: the target", to_string(target.size) + " for a frame of " + to_string(frame.size),
                    "give it the frame's size");
    detail::Run<P, Frame<Set, FrameStorage>, History<P, Storage>, E, Target>(pipeline, frame, history, executor, target).all();
}

} // namespace quell
