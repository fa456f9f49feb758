#pragma once

#include "kernel_language.hpp"

#include <quell/execute/cuda.cuh>

namespace emulated_cuda {

/// Cuda. It tells the device what kernels there are, which nvcc does else.
struct Emulated {
    quell::Cuda cuda;

    template <class Job> void for_each_pixel(quell::Region r, Job const& job) const {
        make_known(quell::detail::each_pixel<Job>);
        cuda.for_each_pixel(r, job);
    }
    template <class Job> void enqueue(quell::Region r, Job const& job) const {
        make_known(quell::detail::each_pixel<Job>);
        cuda.enqueue(r, job);
    }
    template <class Work> void enqueue_grid(quell::Region r, Work const& work) const {
        make_known(quell::detail::whole_grid<Work>);
        cuda.enqueue_grid(r, work);
    }
    void clear(void* memory, std::size_t bytes) const { cuda.clear(memory, bytes); }
    void read(void* to, void const* from, std::size_t bytes) const { cuda.read(to, from, bytes); }
    void submit() const { cuda.submit(); }
    void drop() const { cuda.drop(); }
};
static_assert(quell::QueueExecutor<Emulated>);

} // namespace emulated_cuda
