#pragma once

#include <quell/pipeline/plan.hpp>

#include <cstring>

namespace quell_library::inline QUELL_INSTRUCTION_SET {

/// A queue that computes nothing, of the host. A history takes the memory with it that it takes on a device.
struct NoQueue {
    void for_each_pixel(quell::Region, auto const&) const {}
    void enqueue(quell::Region, auto const&) const {}
    void enqueue_grid(quell::Region, auto const&) const {}
    void clear(void* memory, std::size_t bytes) const { std::memset(memory, 0, bytes); }
    void read(void* to, void const* from, std::size_t bytes) const { std::memcpy(to, from, bytes); }
    void submit() const {}
    void drop() const {}
};
static_assert(quell::QueueExecutor<NoQueue>);

/// As quell::plan_of(), with the memory that a device takes.
template <class P> quell::Plan device_plan_of(P const& pipeline) {
    constexpr quell::Extent size{1024, 16}; // padding hardly counts
    quell::Frame frame{size, pipeline};
    frame.camera.projection[2][3] = -1.f, frame.camera.projection[3][3] = 0.f, frame.camera.projection[3][2] = -1.f;
    quell::History history{size, pipeline};
    for (int i = 0; i < 3; ++i) run(pipeline, frame, history, NoQueue{});
    quell::Plan plan;
    quell::detail::PassesOf<P>::append(plan.passes, pipeline, history);
    plan.bytes_per_pixel = history.bytes_per_pixel();
    return plan;
}

} // namespace quell_library::inline QUELL_INSTRUCTION_SET
