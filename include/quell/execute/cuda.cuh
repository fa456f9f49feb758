#pragma once

#include <quell/core/error.hpp>
#include <quell/execute/cuda_graphs.cuh>
#include <quell/execute/queue_executor.hpp>

#include <type_traits>

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {
/// Whether the device's context is lost with an error: every later call of CUDA returns it, too, until the program ends.
inline bool loses_context(cudaError_t status) {
    return status == cudaErrorIllegalAddress || status == cudaErrorLaunchTimeout || status == cudaErrorAssert ||
           (status >= cudaErrorHardwareStackError && status <= cudaErrorLaunchFailure);
}
/// What a host can do about an error.
/// @param usual where the error does not say it
inline char const* cuda_remedy(cudaError_t status, char const* usual) {
    if (status == cudaErrorMemoryAllocation) return "use smaller images or Float16";
    return loses_context(status) ? "the device's context is lost: start the program again, with frame, history and target in memory that "
                                   "the device can reach: Device<> or Managed<>"
                                 : usual;
}

/// One CUDA thread for each pixel of the region.
template <class Job> __global__ void each_pixel(Region const region, QUELL_GRID_CONSTANT Job const job) {
    int const x = region.x0 + static_cast<int>(blockIdx.x * blockDim.x + threadIdx.x);
    int const y = region.y0 + static_cast<int>(blockIdx.y * blockDim.y + threadIdx.y);
    if (x < region.x1 && y < region.y1) job(at_once<float>, x, y, 1);
}

/// Runs jobs by all threads of a grid, one after the other. All blocks must run at once.
struct WholeGrid {
    Region region;
    unsigned* barrier; ///< how often blocks have come to a barrier; 0 at the beginning

    template <class Job> __device__ void operator()(Job const& job) const {
        int const width = region.x1 - region.x0, height = region.y1 - region.y0;
        int const threads = static_cast<int>(gridDim.x * blockDim.x);
        for (int i = static_cast<int>(blockIdx.x * blockDim.x + threadIdx.x); i < width * height; i += threads)
            job(at_once<float>, region.x0 + i % width, region.y0 + i / width, 1);
        meet();
    }

private:
    /// Returns when all threads have come here, with what they have written. cooperative_groups has the same, and traps in code that tests
    /// could not tell from a compiler's trap.
    __device__ void meet() const {
        __syncthreads();
        if (threadIdx.x == 0) {
            __threadfence();
            auto const all = (atomicAdd(barrier, 1u) / gridDim.x + 1) * gridDim.x;
            while (*static_cast<unsigned volatile*>(barrier) < all) {
            }
            __threadfence();
        }
        __syncthreads();
    }
};
template <class Work> __global__ void __launch_bounds__(256) whole_grid(Region const region, QUELL_GRID_CONSTANT Work const work) {
    work(WholeGrid{region, work.barrier()});
}
} // namespace detail

/// Runs one CUDA thread for each pixel: the same kernels over float as Serial, compiled for the device by
///
///     nvcc -std=c++20 --expt-relaxed-constexpr
///
/// run() puts the frame's passes into the stream and returns: what it returns is complete when the stream has come there. Only the first
/// frame of a history waits. Kernels read and write the images of the frame and of the history, the history's counts and, with run_into(),
/// the host's target: all in memory of their storage, which the device must be able to reach, such as Device<> (execute/device.cuh) and
/// Managed<> (image/managed.cuh). All frames of a history go into one stream, or into streams between which the host waits. See
/// QueueExecutor.
struct Cuda {
    cudaStream_t stream = nullptr;         ///< passes are launched here
    int block_width = 0, block_height = 0; ///< threads; 0: as suits a pass
    CudaGraphs* graphs = nullptr;          ///< where frames become graphs; null: each pass is launched by itself

    /// See Executor: returns when the pass is complete.
    /// @throws Error where the launch or the pass fails
    template <class Job> void for_each_pixel(Region r, Job const& job) const {
        enqueue(r, job);
        wait_for(job.name);
    }
    /// The same without waiting for the end.
    /// @throws Error where the launch fails
    template <class Job> void enqueue(Region r, Job const& job) const {
        static_assert(std::is_trivially_copyable_v<Job>, "a job is copied to the device: policies and views must be trivially copyable");
        if (r.x1 <= r.x0 || r.y1 <= r.y0) return;
        // Measured on an H100. A warp of one row loads whole lines of the cache; in squares, pixels that look at scattered places share
        // them.
        constexpr bool in_squares = [] {
            if constexpr (requires { Job::in_squares; })
                return Job::in_squares;
            else
                return false;
        }();
        bool const given = block_width > 0 && block_height > 0;
        int const width = given ? block_width : in_squares ? 16 : 64, height = given ? block_height : in_squares ? 8 : 2;
        dim3 const block(count(width), count(height)), grid(blocks(r.x1 - r.x0, width), blocks(r.y1 - r.y0, height));
        auto const* const kernel = reinterpret_cast<void const*>(detail::each_pixel<Job>);
        if (graphs) return graphs->add({kernel, job.name, grid, block, false}, r, job);
        void* arguments[] = {&r, const_cast<Job*>(&job)};
        check(cudaLaunchKernel(kernel, grid, block, arguments, 0, stream), job.name, compile_remedy);
    }
    /// See QueueExecutor.
    /// @throws Error where the launch fails
    template <class Work> void enqueue_grid(Region r, Work const& work) const {
        static_assert(std::is_trivially_copyable_v<Work>);
        int device = 0, multiprocessors = 0;
        check(cudaGetDevice(&device), work.name, "select a device");
        check(cudaDeviceGetAttribute(&multiprocessors, cudaDevAttrMultiProcessorCount, device), work.name, "select a device");
        auto const* const kernel = reinterpret_cast<void const*>(detail::whole_grid<Work>);
        // One block on each multiprocessor: all run at once, whatever they need.
        dim3 const grid(count(multiprocessors)), block(256);
        if (graphs) return graphs->add({kernel, work.name, grid, block, true}, r, work);
        void* arguments[] = {&r, const_cast<Work*>(&work)};
        check(cudaLaunchCooperativeKernel(kernel, grid, block, arguments, 0, stream), work.name, compile_remedy);
    }
    /// See QueueExecutor.
    void clear(void* memory, std::size_t bytes) const {
        if (graphs) return graphs->add_clear(memory, bytes);
        check(cudaMemsetAsync(memory, 0, bytes, stream), "counts", remedy);
    }
    /// See QueueExecutor.
    /// @throws Error where the graph cannot be made or launched
    void submit() const {
        if (!graphs) return;
        char const* pass = nullptr;
        auto const status = graphs->submit(stream, pass);
        check(status, pass, compile_remedy);
    }
    /// See QueueExecutor.
    void drop() const {
        if (graphs) graphs->drop_frame();
    }
    /// See QueueExecutor.
    void read(void* to, void const* from, std::size_t bytes) const {
        copy(to, from, bytes);
        synchronize();
    }
    /// Copies between any two places, behind what is in the stream.
    void copy(void* to, void const* from, std::size_t bytes) const {
        submit();
        check(cudaMemcpyAsync(to, from, bytes, cudaMemcpyDefault, stream), "copy", remedy);
    }
    /// Waits for all that is in the stream.
    /// @throws Error where a pass has failed. It says where the device's context is lost: the program can use the device no more then.
    void synchronize() const { wait_for("of the frames before"); }

private:
    static constexpr auto remedy = "keep frame, history and target in memory that the device can reach: Device<> or Managed<>";
    static constexpr auto compile_remedy = "compile for this device's architecture";
    void wait_for(char const* pass) const {
        submit();
        check(cudaStreamSynchronize(stream), pass, remedy);
    }
    static unsigned count(int threads) { return static_cast<unsigned>(threads); }
    static unsigned blocks(int pixels, int threads) { return count((pixels + threads - 1) / threads); }
    static void check(cudaError_t status, char const* pass, char const* advice) {
        if (status == cudaSuccess) return;
        cudaGetLastError(); // forgets it: later calls don't fail for it, if the context is there
        raise_error<Failure>("pass '" + std::string(pass) + "' on the device" + (detail::loses_context(status) ? " or one before it" : ""),
                             cudaGetErrorString(status), detail::cuda_remedy(status, advice));
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
