#include "allocations.hpp"

#include <atomic>
#include <cstdlib>
#include <new>

// The forms for arrays and the nothrow forms call these.

namespace {
std::atomic<long long> counted = 0;

void* count(void* memory) {
    counted.fetch_add(1, std::memory_order_relaxed);
    if (!memory) throw std::bad_alloc();
    return memory;
}
} // namespace

long long quell::bench::allocations() { return counted.load(std::memory_order_relaxed); }

void* operator new(std::size_t size) { return count(std::malloc(size == 0 ? 1 : size)); }
void* operator new(std::size_t size, std::align_val_t align) {
    auto const alignment = static_cast<std::size_t>(align);
    return count(std::aligned_alloc(alignment, (size + alignment) / alignment * alignment));
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
