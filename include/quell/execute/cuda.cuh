#pragma once

#include <quell/core/error.hpp>
#include <quell/execute/executor.hpp>

#include <type_traits>

namespace quell {

namespace detail {
/// One thread of the grid for each pixel of the region.
template <class Job> __global__ void each_pixel(Region region, Job job) {
    int const x = region.x0 + static_cast<int>(blockIdx.x * blockDim.x + threadIdx.x);
    int const y = region.y0 + static_cast<int>(blockIdx.y * blockDim.y + threadIdx.y);
    if (x < region.x1 && y < region.y1) job(at_once<float>, x, y, 1);
}
} // namespace detail

/// A CUDA thread for each pixel: the same kernels over float that Serial runs, compiled for the device by
///     nvcc -std=c++20 --expt-relaxed-constexpr
/// Returns when the pass is complete, as every executor does: run() reads on the host what the ingest has counted. All memory of the frame,
/// the history and the host's stack must be within the device's reach, which plain memory is on systems that share their page tables
/// (HMM, Grace Hopper); elsewhere the storage must allocate managed memory.
struct Cuda {
    cudaStream_t stream = nullptr;
    int block_width = 32, block_height = 4; ///< threads; a warp is one row of 32 pixels, so its loads join

    /// @throws Error where the device refuses the launch or the pass fails
    template <class Job> void for_each_pixel(Region r, Job const& job) const {
        static_assert(std::is_trivially_copyable_v<Job>, "a job is copied to the device: policies and views must be trivially copyable");
        if (r.x1 <= r.x0 || r.y1 <= r.y0) return;
        dim3 const block(count(block_width), count(block_height)),
            grid(blocks(r.x1 - r.x0, block_width), blocks(r.y1 - r.y0, block_height));
        detail::each_pixel<<<grid, block, 0, stream>>>(r, job);
        check(cudaGetLastError(), job.name, "compile for this device's architecture");
        check(cudaStreamSynchronize(stream), job.name, "keep all images in memory that the device can reach");
    }

private:
    static unsigned count(int threads) { return static_cast<unsigned>(threads); }
    static unsigned blocks(int pixels, int threads) { return count((pixels + threads - 1) / threads); }
    static void check(cudaError_t status, char const* pass, char const* remedy) {
        if (status != cudaSuccess) throw Error("pass '" + std::string(pass) + "' on the device", cudaGetErrorString(status), remedy);
    }
};

} // namespace quell
