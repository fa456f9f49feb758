#pragma once

#include "grid.hpp"

#include <deque>
#include <limits>
#include <map>
#include <optional>
#include <utility>

namespace emulated_cuda {

/// What there is of the device: memory, streams, errors.
class Machine {
    struct Memory {
        std::size_t bytes;
        bool for_host;
    };
    struct Operation {
        cudaStream_t stream;
        std::function<void()> run;
    };
    std::map<void*, Memory> memory;
    std::deque<Operation> waiting;
    std::map<std::string, std::pair<int, cudaError_t>> failures;
    cudaError_t last = cudaSuccess, lost = cudaSuccess;
    std::mt19937 random{1};

public:
    Counts counts;
    std::map<void const*, Kernel> kernels;
    std::size_t most_bytes = std::numeric_limits<std::size_t>::max();
    bool break_next = false, moves_memory = false;

    /// Begins a call: the error that it must return.
    cudaError_t begin(std::string const& call);
    cudaError_t end(cudaError_t status) { return last = status == cudaSuccess ? last : status, status; }
    cudaError_t take_error() { return std::exchange(last, lost); }
    void fail(std::string const& call, int after, cudaError_t error) { failures[call] = {after, error}; }
    void restart() { last = lost = cudaSuccess, waiting.clear(), failures.clear(), break_next = false; }

    /// Managed memory that need not be on the device.
    [[nodiscard]] std::size_t managed_in_host() const { return moves_memory ? counts.managed_bytes : 0; }
    cudaError_t allocate(void** to, std::size_t bytes, bool for_host);
    void release(void* block);
    /// Where a pointer points to.
    [[nodiscard]] cudaMemoryType type_of(void const* pointer) const;

    void enqueue(cudaStream_t stream, std::function<void()> run) { waiting.push_back({stream, std::move(run)}); }
    /// Runs all that waits. Returns what is wrong with the device.
    cudaError_t finish();
    /// Runs a kernel that was enqueued.
    void run(Launch const& launch);
    /// Copies a kernel's arguments; none for a kernel that is not there.
    std::optional<Launch> launch_of(void const* function, dim3 grid, dim3 block, void* const* arguments, bool cooperative);

private:
    void protect(bool closed);
    std::size_t next_operation();
};
Machine& machine();

} // namespace emulated_cuda
