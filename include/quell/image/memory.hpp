#pragma once

#include <quell/core/instruction_set.hpp>

#include <concepts>
#include <cstddef>
#include <new>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Where images lie: two static functions. Memory is aligned to 64 bytes at least.
///
///     static void* allocate(std::size_t bytes);   static void release(void* memory);
///
/// Memory that the host cannot reach says so, and has two more:
///
///     static constexpr bool on_host = false;
///     static void clear(void* memory, std::size_t bytes);   static void copy(void* to, void const* from, std::size_t bytes);
///
/// Models: HostMemory, ManagedMemory (image/managed.cuh), DeviceMemory (execute/device.cuh).
template <class M>
concept ImageMemory = requires(std::size_t bytes, void* memory) {
    { M::allocate(bytes) } -> std::same_as<void*>;
    M::release(memory);
};

namespace detail {
/// Whether the host can reach memory.
template <class Memory> constexpr bool reached_by_host() {
    if constexpr (requires { Memory::on_host; })
        return Memory::on_host;
    else
        return true;
}
} // namespace detail

/// What operator new[] gives.
struct HostMemory {
    /// Uninitialised.
    static void* allocate(std::size_t bytes) { return ::operator new[](bytes, std::align_val_t{64}); }
    /// Gives back what allocate() gave.
    static void release(void* memory) { ::operator delete[](memory, std::align_val_t{64}); }
};

namespace detail {
template <class Storage> struct MemoryOfStorage { using type = HostMemory; };
template <class Storage>
    requires ImageMemory<typename Storage::Memory>
struct MemoryOfStorage<Storage> {
    using type = typename Storage::Memory;
};
} // namespace detail

/// Where a storage keeps what kernels write: its `Memory`, or HostMemory.
template <class Storage> using MemoryOf = typename detail::MemoryOfStorage<Storage>::type;

} // namespace quell::inline QUELL_INSTRUCTION_SET
