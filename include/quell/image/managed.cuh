#pragma once

#include <quell/core/error.hpp>
#include <quell/image/planar.hpp>

#include <cuda_runtime_api.h>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Memory that both the host and the device reach: pages go to where they are used.
struct ManagedMemory {
    /// Uninitialised.
    /// @throws Error where there is no device, or not enough memory
    static void* allocate(std::size_t bytes) {
        void* memory = nullptr;
        if (auto const status = cudaMallocManaged(&memory, bytes); status != cudaSuccess) {
            cudaGetLastError(); // forgets it: the device can still be used
            raise_error("managed memory of " + std::to_string(bytes) + " bytes", cudaGetErrorString(status),
                        status == cudaErrorMemoryAllocation ? "use smaller images or Float16"
                                                            : "run on a machine with an NVIDIA GPU and a driver that is as new as CUDA");
        }
        return memory;
    }
    /// Gives back what allocate() gave. No kernel may be using it.
    static void release(void* memory) { cudaFree(memory); }
};

/// Planar images in memory that the device can reach, for frames and histories of the executor Cuda.
/// @tparam Format Float32 or Float16; channels with `full_precision` use Float32 anyway
template <class Format = Float32> using Managed = Planar<Format, ManagedMemory>;

} // namespace quell::inline QUELL_INSTRUCTION_SET
