#pragma once

#include <quell/frame/cursor/pixel.hpp>

/// Sums over blocks of the frame, and over all of it, as passes: each of 8x8 pixels of the one before.
namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// The fraction of a channel that has one pixel for the whole frame, up to so many pixels wide and high. Larger frames have several.
inline constexpr int whole_frame = 32768;
inline constexpr int blocks_side = 8; ///< of what a pass sums, in its pixels

/// Calls body(i, j, weight) for the 8x8 pixels of a finer resolution that a pixel covers, row by row. Those beside the frame weigh 0, all
/// others 1.
template <class Px, class Body> QUELL_KERNEL void for_each_finer(Px const& px, Body&& body) {
    using Real = typename Px::Real;
    constexpr auto finer = static_cast<float>(Px::Scope::fraction / blocks_side);
    auto const width = to_real(px.frame_size().width), height = to_real(px.frame_size().height);
    auto const left = px.columns() * static_cast<float>(blocks_side), top = px.row_of_lanes() * static_cast<float>(blocks_side);
    for (int j = 0; j < blocks_side; ++j)
        for (int i = 0; i < blocks_side; ++i) {
            auto const inside =
                both((left + static_cast<float>(i)) * finer < Real(width), (top + static_cast<float>(j)) * finer < Real(height));
            body(i, j, masked(inside, Real(1.f)));
        }
}

/// Sums of sums.
/// @tparam Sums a channel of sums over blocks, by its fraction
template <template <int> class Sums, int its_fraction> struct SumBlocks {
    static constexpr auto name = "sum blocks";
    static constexpr int fraction = its_fraction;
    using reads = Channels<Sums<its_fraction / blocks_side>>;
    using emits = Channels<Sums<its_fraction>>;
    static constexpr int farthest_tap = 0;

    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        auto sum = zero<Value<Sums<1>::components, Real>>();
        for_each_finer(px, [&](int i, int j, Real weight)
                               QUELL_INLINED { sum = add_scaled(sum, px.finer(Sums<its_fraction / blocks_side>{}, i, j), weight); });
        return emitted<Real>(Sums<its_fraction>{}, sum);
    }
};

/// All of those from blocks of 8x8 pixels to the whole frame.
template <template <int> class Sums> struct SumFrame {
    using parts = Parts<SumBlocks<Sums, 64>, SumBlocks<Sums, 512>, SumBlocks<Sums, 4096>, SumBlocks<Sums, whole_frame>>;
    constexpr void for_each_pass(auto&& pass) const {
        pass(SumBlocks<Sums, 64>{}), pass(SumBlocks<Sums, 512>{}), pass(SumBlocks<Sums, 4096>{}), pass(SumBlocks<Sums, whole_frame>{});
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
