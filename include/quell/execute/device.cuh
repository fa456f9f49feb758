#pragma once

#include <quell/core/error.hpp>
#include <quell/execute/cuda.cuh>
#include <quell/image/planar.hpp>

#include <cuda_runtime_api.h>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Memory of the device, which the host cannot reach.
struct DeviceMemory {
    static constexpr bool on_host = false; ///< see ImageMemory
    /// Uninitialised.
    /// @throws Error where there is no device, or not enough memory
    static void* allocate(std::size_t bytes) {
        void* memory = nullptr;
        if (auto const status = cudaMalloc(&memory, bytes); status != cudaSuccess) {
            cudaGetLastError(); // forgets it: the device can still be used
            raise_error("device memory of " + std::to_string(bytes) + " bytes", cudaGetErrorString(status),
                        status == cudaErrorMemoryAllocation ? "use smaller images or Float16"
                                                            : "run on a machine with an NVIDIA GPU and a driver that is as new as CUDA");
        }
        return memory;
    }
    /// Gives back what allocate() gave, when all kernels that have been launched are done.
    static void release(void* memory) { cudaFree(memory); }
    /// Sets memory to zero.
    static void clear(void* memory, std::size_t bytes) {
        check(cudaMemset(memory, 0, bytes));
        wait(); // another stream may use the memory next
    }
    /// Copies from one place to another.
    static void copy(void* to, void const* from, std::size_t bytes) {
        check(cudaMemcpy(to, from, bytes, cudaMemcpyDeviceToDevice));
        wait();
    }

private:
    static void wait() { check(cudaStreamSynchronize(cudaStreamLegacy)); }
    static void check(cudaError_t status) {
        if (status != cudaSuccess)
            raise_error<Failure>("memory of the device", cudaGetErrorString(status),
                                 detail::cuda_remedy(status, "look for an error of an earlier call of CUDA"));
    }
};

/// Planar images in memory of the device, for frames and histories of the executor Cuda. The host fills them by upload(), or by kernels of
/// its own, and gets pictures by download().
/// @tparam Format Float32 or Float16; channels with `full_precision` use Float32 anyway
template <class Format = Float32> using Device = Planar<Format, DeviceMemory>;

namespace detail {
/// Copies pixels and the padding between them.
template <class To, class From> void copy_planes(To const& to, From const& from, Cuda const& cuda) {
    static_assert(To::components == From::components && std::is_same_v<typename To::Element, typename From::Element>,
                  "upload() and download(): the two images must have the same components and the same format");
    if (!(to.size == from.size))
        raise_error<Failure>("a copy to or from the device", to_string(from.size) + " to " + to_string(to.size),
                             "give both images one size");
    auto const bytes = static_cast<std::size_t>(to.row_stride() * to.size.height) * sizeof(typename To::Element);
    for (int c = 0; c < To::components; ++c) cuda.copy(to.planes[c], from.planes[c], bytes);
}
} // namespace detail

/// Copies an image of the host's, Planar<Format>, to one of a Device<Format> frame, behind what is in the stream. Returns when it is done.
template <class To, class From> void upload(To const& to, From const& from, Cuda const& cuda = {}) {
    detail::copy_planes(to.view(), from.view(), cuda);
    cuda.synchronize();
}

/// Waits for what is in the stream, and returns an image of the host's.
/// @param view what run() returned, or of an image of a Device<> frame or of a history
template <class Format, int N> auto download(detail::PlanarView<Format, N, DeviceMemory> const& view, Cuda const& cuda = {}) {
    typename Planar<Format>::template Image<N> image(view.size);
    detail::copy_planes(image.view(), view, cuda);
    cuda.synchronize();
    return image;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET
