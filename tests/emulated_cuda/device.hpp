#pragma once

#include <cuda_runtime_api.h>

#include <cstddef>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

// A device that is the host's own processor. It runs kernels as CUDA may run them, and is strict where CUDA only may be:
// - What is put into a stream runs when the host waits, not before. Streams take turns at random; the legacy stream waits for all.
// - Blocks, the warps of 32 in them and the threads of a warp run in random order, each thread by itself. In a cooperative launch all
//   threads of all blocks exist at once, and __syncthreads() is a barrier.
// - The host can't touch memory of the device: a program that does crashes.
// - Arguments are copied when a kernel is launched, or when a graph gets them.
namespace emulated_cuda {

/// A kernel by its address: how large its arguments are, and how one thread runs it.
struct Kernel {
    std::vector<std::size_t> sizes;
    std::function<void(std::vector<void const*> const& arguments)> run;
};
/// Makes the kernel at this address known, as nvcc would.
void make_known(void const* function, Kernel kernel);

/// The same for a kernel of two arguments.
template <class First, class Second> void make_known(void (*kernel)(First, Second)) {
    make_known(reinterpret_cast<void const*>(kernel),
               {{sizeof(First), sizeof(Second)}, [kernel](std::vector<void const*> const& arguments) {
                    kernel(*static_cast<First const*>(arguments[0]), *static_cast<Second const*>(arguments[1]));
                }});
}

/// What the host has asked for since the program began.
struct Counts {
    int allocations = 0, releases = 0; ///< of memory
    int launches = 0;                  ///< of kernels, by themselves
    int graphs = 0;                    ///< made
    int graph_launches = 0;
    int changed_arguments = 0;     ///< of kernels of graphs
    int kernels = 0;               ///< that have run
    int waits = 0;                 ///< for a stream
    std::size_t managed_bytes = 0; ///< of `bytes`
    std::size_t bytes = 0;         ///< held
};
Counts const& counts();

/// Lets the call with that name fail once, after it has succeeded so many times.
void fail(std::string const& call, int after, cudaError_t error);
/// The most bytes of memory that can be held, without managed memory where that can be moved to and from the device.
void limit_memory(std::size_t bytes);
/// Whether the device can use more managed memory than it has.
void move_memory(bool can);
/// The next kernel to run fails, and with it all calls until restart().
void break_device();
/// What the end of the program and a new one would do: there is no error any more.
void restart();

} // namespace emulated_cuda
