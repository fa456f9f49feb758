#pragma once

#include <quell/execute/executor.hpp>

#include <cstddef>
#include <type_traits>

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {
struct AnyGridWork {
    static constexpr auto name = "any";
    void operator()(auto const&) const {}
    unsigned* barrier() const { return nullptr; }
};
} // namespace detail

/// An executor that puts passes into a queue of a device, and returns before they have run. Beside for_each_pixel, which waits, it has
///
///     void enqueue(Region region, auto const& job) const                       // for_each_pixel, later
///     void enqueue_grid(Region region, auto const& work) const                 // work(for_all), later
///     void clear(void* memory, std::size_t bytes) const                        // sets memory of the device to zero, later
///     void read(void* to, void const* from, std::size_t bytes) const           // waits for the queue, then copies to the host
///     void submit() const                                                      // the frame is complete: what was put in may run
///     void drop() const                                                        // an error has ended the frame: what was put in and not
///                                                                              // submitted must not run
///
/// What is put in runs in that order. `work(for_all)` runs once in every thread of a grid; `for_all(job)` there runs a job for every pixel
/// of the region, by all threads together, and returns when all are done; `work.barrier()` is a zero of the device for that. run() with
/// such an executor returns before the frame is done. It waits only in the first frame of a history. A history keeps a copy of the
/// executor, for statistics(). Model: Cuda.
template <class E>
concept QueueExecutor = Executor<E> && std::is_trivially_copyable_v<E> &&
    requires(E const e, Region region, detail::AnyJob job, detail::AnyGridWork work, void* memory, std::size_t bytes) {
    e.enqueue(region, job);
    e.enqueue_grid(region, work);
    e.clear(memory, bytes);
    e.read(memory, memory, bytes);
    e.submit();
    e.drop();
};

namespace detail {
/// What code without templates does with a QueueExecutor.
struct QueueCalls {
    void (*clear)(void const* executor, void* memory, std::size_t bytes);
    void (*read)(void const* executor, void* to, void const* from, std::size_t bytes);
    void (*submit)(void const* executor);
    void (*drop)(void const* executor);
    std::size_t size; ///< of the executor
};
template <class E>
inline constexpr QueueCalls queue_calls = {
    [](void const* e, void* memory, std::size_t bytes) { static_cast<E const*>(e)->clear(memory, bytes); },
    [](void const* e, void* to, void const* from, std::size_t bytes) { static_cast<E const*>(e)->read(to, from, bytes); },
    [](void const* e) { static_cast<E const*>(e)->submit(); }, [](void const* e) { static_cast<E const*>(e)->drop(); }, sizeof(E)};
/// Null for other executors.
template <class E> constexpr QueueCalls const* queue_of() {
    if constexpr (QueueExecutor<E>) {
        static_assert(sizeof(E) <= 64, "an executor with a queue is copied into histories: it must have at most 64 bytes");
        return &queue_calls<E>;
    } else
        return nullptr;
}

/// Runs a job at once, or puts it into the executor's queue.
template <class E, class Job> QUELL_FLATTENED void run_or_enqueue(E const& executor, Region region, Job const& job) {
    if constexpr (QueueExecutor<E>)
        executor.enqueue(region, job);
    else
        executor.for_each_pixel(region, job);
}
/// Lets what was put into the executor's queue run.
template <class E> void submit_queue(E const& executor) {
    if constexpr (QueueExecutor<E>) executor.submit();
}
} // namespace detail

} // namespace quell::inline QUELL_INSTRUCTION_SET
