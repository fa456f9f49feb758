#pragma once

#include <quell/image/memory.hpp>
#include <quell/pipeline/statistics.hpp>

#include <atomic>
#include <memory>
#include <new>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Atomic addition. A template: other constexpr functions cannot call one that is not constexpr.
template <class Whole> QUELL_KERNEL void add_together(std::atomic<Whole>& sum, Whole more) {
#if defined(__CUDA_ARCH__) // device code has no std::atomic: nvcc would silently drop the call
    atomicAdd(reinterpret_cast<unsigned long long*>(&sum), static_cast<unsigned long long>(more));
#else
    sum.fetch_add(more, std::memory_order_relaxed);
#endif
}

/// A count that no other thread changes at the time.
template <class Whole> QUELL_KERNEL Whole read_count(std::atomic<Whole> const& count) {
#if defined(__CUDA_ARCH__)
    return *reinterpret_cast<Whole const*>(&count);
#else
    return count.load(std::memory_order_relaxed);
#endif
}

/// A sum that does not depend on the order of its terms, as a sum of floats would. `larges` counts multiples of 2^16, `smalls` the rest in
/// multiples of 2^-22. Neither overflows with up to 2^25 samples of 1e16. That is a quarter of 2^27 pixels; more cannot outshine all their
/// neighbours.
class EnergySum {
    static constexpr float large_unit = 65536.f, small_unit = 1.f / 4194304.f;
    std::atomic<long long> larges = 0, smalls = 0;

public:
    template <class Real> QUELL_KERNEL void add(Real energy) {
        auto const whole = static_cast<long long>(energy / large_unit);
        auto const rest = energy - static_cast<float>(whole) * large_unit; // exact: `whole` has no more digits than `energy`
        if (whole > 0) add_together(larges, whole);
        add_together(smalls, static_cast<long long>(rest / small_unit));
    }
    void reset() { larges = 0, smalls = 0; }
    [[nodiscard]] double total() const {
        return static_cast<double>(larges) * static_cast<double>(large_unit) +
               static_cast<double>(smalls) * static_cast<double>(small_unit);
    }
};

/// Pixels with impossible guides, by the guide.
class GuideCounts {
    std::atomic<long long> by_guide[CheckedGuides::size] = {};

public:
    std::atomic<long long> pixels = 0; ///< with one or more

    /// Counts a pixel's ImpossibleGuides.
    QUELL_KERNEL void add(float impossible) {
        auto const all = static_cast<int>(impossible);
        if (all == 0) return;
        add_together(pixels, 1LL);
        for (int i = 0; i < CheckedGuides::size; ++i)
            if ((all >> i & 1) != 0) add_together(by_guide[i], 1LL);
    }
    void reset() {
        pixels = 0;
        for (auto& count : by_guide) count = 0;
    }
    /// Of the guide with a number among CheckedGuides.
    [[nodiscard]] QUELL_KERNEL long long of(int number) const { return read_count(by_guide[number]); }
    [[nodiscard]] RepairedGuides total() const {
        RepairedGuides all{.pixels = read_count(pixels)};
        for (std::size_t i = 0; i < all.by_guide.size(); ++i) all.by_guide[i] = read_count(by_guide[i]);
        return all;
    }
};

/// Counts of the ingest, from any number of threads.
struct Counts {
    std::atomic<long long> missing = 0;
    std::atomic<long long> holes = 0; ///< of the missing ones: those for which nothing stands in yet
    EnergySum suppressed;
    GuideCounts guides;

    void reset() { missing = 0, holes = 0, suppressed.reset(), guides.reset(); }
};

/// Counts of a frame.
struct FrameCounts {
    Counts first;      ///< of the ingest
    Counts again;      ///< of a second one, with repaired guides
    Counts filled[16]; ///< of each pass of FillHoles in a queue
    unsigned barrier;  ///< of a queue's grid
};

/// Counts that lie where kernels can write them.
template <class Memory> std::shared_ptr<FrameCounts> counts_in() {
    void* const memory = Memory::allocate(sizeof(FrameCounts));
    auto const release = [](FrameCounts* counts) { Memory::release(counts); };
    if constexpr (reached_by_host<Memory>())
        return {new (memory) FrameCounts, release};
    else
        return {static_cast<FrameCounts*>(memory), release}; // a queue clears them before each frame
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
