#pragma once

#include <quell/pipeline/graph/list_passes.hpp>
#include <quell/pipeline/graph/run_passes.hpp>
#include <quell/pipeline/history.hpp>
#include <quell/pipeline/wrong_calls.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {
/// Its address tells the types that a list of passes depends on. Not const: linkers may merge equal constants.
template <class K, std::size_t stages> inline char maker_of_list = 0;

/// Hands a list to a ListExecutor; null for other executors.
template <class E> constexpr auto run_list_of() {
    using Function = void (*)(void const*, std::span<ListedPass const>);
    if constexpr (ListExecutor<E>)
        return Function(
            [](void const* executor, std::span<ListedPass const> passes) { static_cast<E const*>(executor)->run_list(passes); });
    else
        return Function(nullptr);
}

/// Runs the first `stages` stages of a pipeline. Returns a view of the output; empty where it went to a target.
/// @param follows of a link without a past of its own: whether the frame before is part of the picture that it is given
template <std::size_t stages, class P, class Set, class FrameStorage, class Storage, class E, class Into>
auto run_stages(P const& pipeline, Frame<Set, FrameStorage> const& frame, History<P, Storage>& history, E const& executor, Into const& into,
                bool follows = false) {
    static_assert(QueueExecutor<E> || (reached_by_host<MemoryOf<Storage>>() && reached_by_host<MemoryOf<FrameStorage>>()),
                  "run(pipeline, frame, history, executor): the images lie in the device's memory: give the executor Cuda{stream}");
    check_frame<P>(frame);
    auto& images = OpenHistory::images(history);
    using K = Kernels<P, Frame<Set, FrameStorage>, Storage, E, Into>;
    images.passes.update(&maker_of_list<K, stages>, pipeline, [&](PassList& list) {
        list_passes<stages, FrameStorage, Storage, K>(pipeline, list, !std::is_same_v<Into, NoTarget>);
    });
    TypedByKernel const typed{&pipeline, &frame, &executor, &into, run_list_of<E>(), queue_of<E>()};
    PassRunner(images, typed, {frame.size, frame.camera, frame.number, frame.shutter, P::needs_camera, follows}).run();
    return view_in<Storage, typename P::Output>(images.output);
}
} // namespace detail

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
        return detail::run_stages<detail::StageOrder<P>::count>(pipeline, frame, history, executor, detail::NoTarget{});
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
        static_assert(P::has_temporal, "accumulate(pipeline, ...): the pipeline has no Temporal{...}, so there is nothing to accumulate");
        return detail::run_stages<detail::StageOrder<P>::up_to_temporal>(pipeline, frame, history, executor, detail::NoTarget{});
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
        detail::run_stages<detail::StageOrder<P>::count>(pipeline, frame, history, executor, target);
    }
}

} // namespace quell::inline QUELL_INSTRUCTION_SET
