#pragma once

#include <quell/core/error.hpp>
#include <quell/execute/executor.hpp>

#include <type_traits>

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {
/// One CUDA thread for each pixel of the region.
template <class Job> __global__ void each_pixel(Region region, Job job) {
    int const x = region.x0 + static_cast<int>(blockIdx.x * blockDim.x + threadIdx.x);
    int const y = region.y0 + static_cast<int>(blockIdx.y * blockDim.y + threadIdx.y);
    if (x < region.x1 && y < region.y1) job(at_once<float>, x, y, 1);
}
} // namespace detail

/// Runs one CUDA thread for each pixel: the same kernels over float as Serial, compiled for the device by
///
///     nvcc -std=c++20 --expt-relaxed-constexpr
///
/// Returns when the pass is complete. The device must be able to read the memory of the frame, of the history and of the host's stack.
/// Systems with shared page tables (HMM, Grace Hopper) can; elsewhere the storage must allocate managed memory.
struct Cuda {
    cudaStream_t stream = nullptr;          ///< passes are launched here
    int block_width = 32, block_height = 4; ///< threads; a warp is one row of 32 pixels, so its loads coalesce

    /// See Executor.
    /// @throws Error where the launch or the pass fails
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
        if (status != cudaSuccess) raise_error<Failure>("pass '" + std::string(pass) + "' on the device", cudaGetErrorString(status), remedy);
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
