#pragma once

#include <quell/core/error.hpp>
#include <quell/execute/executor.hpp>

#include <type_traits>

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {
/// One CUDA thread for each pixel of the region.
template <class Job> __global__ void each_pixel(Region const region, QUELL_GRID_CONSTANT Job const job) {
    int const x = region.x0 + static_cast<int>(blockIdx.x * blockDim.x + threadIdx.x);
    int const y = region.y0 + static_cast<int>(blockIdx.y * blockDim.y + threadIdx.y);
    if (x < region.x1 && y < region.y1) job(at_once<float>, x, y, 1);
}
} // namespace detail

/// Runs one CUDA thread for each pixel: the same kernels over float as Serial, compiled for the device by
///
///     nvcc -std=c++20 --expt-relaxed-constexpr
///
/// Returns when the pass is complete. Kernels read and write the images of the frame and of the history, the history's counts and, with
/// run_into(), the host's target: all in memory of their storage, which the device must be able to reach. Managed<> (image/managed.cuh) is
/// such a storage.
struct Cuda {
    cudaStream_t stream = nullptr;          ///< passes are launched here
    int block_width = 32, block_height = 4; ///< threads; a warp is one row of 32 pixels, so its loads coalesce

    /// See Executor.
    /// @throws Error where the launch or the pass fails
    template <class Job> void for_each_pixel(Region r, Job const& job) const {
        launch(r, job);
        check(cudaStreamSynchronize(stream), job.name, "keep frame, history and target in memory that the device can reach: Managed<>");
    }
    /// The same without waiting for the end.
    /// @throws Error where the launch fails
    template <class Job> void launch(Region r, Job const& job) const {
        static_assert(std::is_trivially_copyable_v<Job>, "a job is copied to the device: policies and views must be trivially copyable");
        if (r.x1 <= r.x0 || r.y1 <= r.y0) return;
        dim3 const block(count(block_width), count(block_height)),
            grid(blocks(r.x1 - r.x0, block_width), blocks(r.y1 - r.y0, block_height));
        detail::each_pixel<<<grid, block, 0, stream>>>(r, job);
        check(cudaGetLastError(), job.name, "compile for this device's architecture");
    }

private:
    static unsigned count(int threads) { return static_cast<unsigned>(threads); }
    static unsigned blocks(int pixels, int threads) { return count((pixels + threads - 1) / threads); }
    static void check(cudaError_t status, char const* pass, char const* remedy) {
        if (status != cudaSuccess)
            raise_error<Failure>("pass '" + std::string(pass) + "' on the device", cudaGetErrorString(status), remedy);
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
