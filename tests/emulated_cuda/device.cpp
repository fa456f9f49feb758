#include "machine.hpp"

#include <sys/mman.h>

#include <algorithm>

namespace emulated_cuda {

Machine& machine() {
    static Machine the_machine;
    return the_machine;
}
Counts const& counts() { return machine().counts; }
void make_known(void const* function, Kernel kernel) { machine().kernels.try_emplace(function, std::move(kernel)); }
void fail(std::string const& call, int after, cudaError_t error) { machine().fail(call, after, error); }
void limit_memory(std::size_t bytes) { machine().most_bytes = bytes; }
void move_memory(bool can) { machine().moves_memory = can; }
void break_device() { machine().break_next = true; }
void restart() { machine().restart(); }

cudaError_t Machine::begin(std::string const& call) {
    if (lost != cudaSuccess) return lost;
    auto const found = failures.find(call);
    if (found == failures.end() || found->second.first-- > 0) return cudaSuccess;
    auto const error = found->second.second;
    failures.erase(found);
    return error;
}

cudaError_t Machine::allocate(void** to, std::size_t bytes, bool for_host) {
    if (!(for_host && moves_memory) && counts.bytes - managed_in_host() + bytes > most_bytes) return cudaErrorMemoryAllocation;
    *to = mmap(nullptr, bytes, for_host ? PROT_READ | PROT_WRITE : PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (*to == MAP_FAILED) return cudaErrorMemoryAllocation;
    ++counts.allocations, counts.bytes += bytes, counts.managed_bytes += for_host ? bytes : 0;
    memory[*to] = {bytes, for_host};
    return cudaSuccess;
}
void Machine::release(void* block) {
    auto const found = memory.find(block);
    ++counts.releases, counts.bytes -= found->second.bytes, counts.managed_bytes -= found->second.for_host ? found->second.bytes : 0;
    munmap(block, found->second.bytes);
    memory.erase(found);
}
cudaMemoryType Machine::type_of(void const* pointer) const {
    auto const* const at = static_cast<std::byte const*>(pointer);
    for (auto const& [block, kind] : memory) {
        auto const* const begin = static_cast<std::byte const*>(block);
        if (at >= begin && at < begin + kind.bytes) return kind.for_host ? cudaMemoryTypeManaged : cudaMemoryTypeDevice;
    }
    return cudaMemoryTypeUnregistered;
}
void Machine::protect(bool closed) {
    for (auto const& [block, kind] : memory)
        if (!kind.for_host) mprotect(block, kind.bytes, closed ? PROT_NONE : PROT_READ | PROT_WRITE);
}

/// The first operation of a stream that none of the legacy stream stands before; the legacy stream's where it is the very first.
std::size_t Machine::next_operation() {
    if (waiting[0].stream == cudaStreamLegacy) return 0;
    std::vector<std::size_t> firsts;
    for (std::size_t i = 0; i < waiting.size() && waiting[i].stream != cudaStreamLegacy; ++i)
        if (std::none_of(firsts.begin(), firsts.end(), [&](std::size_t other) { return waiting[other].stream == waiting[i].stream; }))
            firsts.push_back(i);
    return firsts[random() % firsts.size()];
}
cudaError_t Machine::finish() {
    protect(false);
    while (!waiting.empty() && lost == cudaSuccess) {
        auto const place = waiting.begin() + static_cast<std::ptrdiff_t>(next_operation());
        auto const run = std::move(place->run);
        waiting.erase(place);
        run();
    }
    waiting.clear();
    protect(true);
    return lost;
}
void Machine::run(Launch const& launch) {
    if (lost != cudaSuccess) return;
    if (std::exchange(break_next, false)) {
        lost = cudaErrorIllegalAddress;
        return;
    }
    ++counts.kernels;
    run_grid(launch, random);
}
std::optional<Launch> Machine::launch_of(void const* function, dim3 grid, dim3 block, void* const* arguments, bool cooperative) {
    auto const found = kernels.find(function);
    if (found == kernels.end()) return {};
    Launch launch{&found->second, grid, block, {}, cooperative};
    for (std::size_t i = 0; i < launch.kernel->sizes.size(); ++i) {
        auto const* const bytes = static_cast<std::byte const*>(arguments[i]);
        launch.arguments.emplace_back(bytes, bytes + launch.kernel->sizes[i]);
    }
    return launch;
}

namespace {
cudaError_t launch(char const* call, void const* function, dim3 grid, dim3 block, void** arguments, cudaStream_t stream, bool cooperative) {
    auto& m = machine();
    if (auto const status = m.begin(call); status != cudaSuccess) return m.end(status);
    if (block.x * block.y * block.z > 1024) return m.end(cudaErrorInvalidValue);
    if (cooperative && grid.x * grid.y * grid.z > multiprocessors) return m.end(cudaErrorCooperativeLaunchTooLarge);
    auto const made = m.launch_of(function, grid, block, arguments, cooperative);
    if (!made) return m.end(cudaErrorInvalidDeviceFunction);
    ++m.counts.launches;
    m.enqueue(stream, [made] { machine().run(*made); });
    return cudaSuccess;
}
/// A call that puts something into a stream.
cudaError_t later(char const* call, cudaStream_t stream, std::function<void()> run) {
    auto& m = machine();
    if (auto const status = m.begin(call); status != cudaSuccess) return m.end(status);
    m.enqueue(stream, std::move(run));
    return cudaSuccess;
}
cudaError_t allocate(char const* call, void** memory, std::size_t bytes, bool for_host) {
    auto& m = machine();
    if (auto const status = m.begin(call); status != cudaSuccess) return m.end(status);
    return m.end(m.allocate(memory, bytes, for_host));
}
cudaError_t finish(char const* call) {
    auto& m = machine();
    if (auto const status = m.begin(call); status != cudaSuccess) return m.end(status);
    return m.end(m.finish());
}
} // namespace
} // namespace emulated_cuda

using emulated_cuda::machine;

char const* cudaGetErrorString(cudaError_t error) {
    switch (error) {
    case cudaSuccess:
        return "no error";
    case cudaErrorInvalidValue:
        return "invalid argument";
    case cudaErrorMemoryAllocation:
        return "out of memory";
    case cudaErrorInvalidDeviceFunction:
        return "invalid device function";
    case cudaErrorNoDevice:
        return "no CUDA-capable device is detected";
    case cudaErrorIllegalAddress:
        return "an illegal memory access was encountered";
    case cudaErrorLaunchTimeout:
        return "the launch timed out and was terminated";
    case cudaErrorAssert:
        return "device-side assert triggered";
    case cudaErrorHardwareStackError:
        return "hardware stack error";
    case cudaErrorLaunchOutOfResources:
        return "too many resources requested for launch";
    case cudaErrorLaunchFailure:
        return "unspecified launch failure";
    case cudaErrorCooperativeLaunchTooLarge:
        return "too many blocks in cooperative launch";
    }
    return "unknown error";
}
cudaError_t cudaGetLastError() { return machine().take_error(); }
cudaError_t cudaGetDeviceCount(int* count) { return *count = 1, machine().end(machine().begin("cudaGetDeviceCount")); }
cudaError_t cudaSetDevice(int device) { return machine().end(device == 0 ? cudaSuccess : cudaErrorInvalidValue); }
cudaError_t cudaGetDevice(int* device) { return *device = 0, machine().end(machine().begin("cudaGetDevice")); }
cudaError_t cudaDeviceGetAttribute(int* value, cudaDeviceAttr attribute, int) {
    *value = attribute == cudaDevAttrMultiProcessorCount ? static_cast<int>(emulated_cuda::multiprocessors) : machine().moves_memory;
    return machine().end(machine().begin("cudaDeviceGetAttribute"));
}

cudaError_t cudaMalloc(void** memory, std::size_t bytes) { return emulated_cuda::allocate("cudaMalloc", memory, bytes, false); }
cudaError_t cudaMallocManaged(void** memory, std::size_t bytes) {
    return emulated_cuda::allocate("cudaMallocManaged", memory, bytes, true);
}
cudaError_t cudaFree(void* memory) {
    auto const status = machine().finish(); // CUDA waits for the device, too
    if (memory) machine().release(memory);
    return machine().end(status);
}
cudaError_t cudaMemGetInfo(std::size_t* free, std::size_t* all) {
    *all = machine().most_bytes, *free = *all - (machine().counts.bytes - machine().managed_in_host());
    return machine().end(machine().begin("cudaMemGetInfo"));
}
cudaError_t cudaPointerGetAttributes(cudaPointerAttributes* attributes, void const* pointer) {
    *attributes = {machine().type_of(pointer), 0, nullptr, nullptr};
    return machine().end(machine().begin("cudaPointerGetAttributes"));
}
cudaError_t cudaMemset(void* memory, int value, std::size_t bytes) {
    auto const status = cudaMemsetAsync(memory, value, bytes, cudaStreamLegacy);
    return status == cudaSuccess ? emulated_cuda::finish("cudaMemset") : status;
}
cudaError_t cudaMemcpy(void* to, void const* from, std::size_t bytes, cudaMemcpyKind kind) {
    auto const status = cudaMemcpyAsync(to, from, bytes, kind, cudaStreamLegacy);
    return status == cudaSuccess ? emulated_cuda::finish("cudaMemcpy") : status;
}
cudaError_t cudaMemsetAsync(void* memory, int value, std::size_t bytes, cudaStream_t stream) {
    return emulated_cuda::later("cudaMemsetAsync", stream, [=] { std::memset(memory, value, bytes); });
}
cudaError_t cudaMemcpyAsync(void* to, void const* from, std::size_t bytes, cudaMemcpyKind, cudaStream_t stream) {
    return emulated_cuda::later("cudaMemcpyAsync", stream, [=] { std::memcpy(to, from, bytes); });
}

struct CUstream_st {};
cudaError_t cudaStreamCreate(cudaStream_t* stream) { return *stream = new CUstream_st, cudaSuccess; }
cudaError_t cudaStreamDestroy(cudaStream_t stream) {
    auto const status = machine().finish();
    delete stream;
    return status;
}
cudaError_t cudaStreamSynchronize(cudaStream_t) {
    ++machine().counts.waits;
    return emulated_cuda::finish("cudaStreamSynchronize");
}

cudaError_t cudaLaunchKernel(void const* function, dim3 grid, dim3 block, void** arguments, std::size_t, cudaStream_t stream) {
    return emulated_cuda::launch("cudaLaunchKernel", function, grid, block, arguments, stream, false);
}
cudaError_t cudaLaunchCooperativeKernel(void const* function, dim3 grid, dim3 block, void** arguments, std::size_t, cudaStream_t stream) {
    return emulated_cuda::launch("cudaLaunchCooperativeKernel", function, grid, block, arguments, stream, true);
}
