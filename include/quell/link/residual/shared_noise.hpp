#pragma once

#include <quell/link/residual/residual.hpp>

#include <array>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// How far neighbouring pixels have their noise in common. It is nothing where each pixel has samples of its own. Splatted samples,
/// pictures that were enlarged or filtered, and samples that pixels hand to each other share it: what is held out there is held out of
/// nothing.
///
/// The measure is the correlation of e(p) and e(q) over neighbours p and q, where e is what samples have more than a picture of them. It is
/// taken by windows of 8x8 pixels, of rows and of columns whichever is less, since what the picture has wrong neighbours have in common
/// too. Of all windows it is the quartile from below: some of them have a picture that is right.
struct SharedNoise {
    float least = .03f; ///< part that noise of single pixels may have by chance and by what a picture has wrong
    float most = .13f;  ///< part from which on noise is that of several pixels
};

/// How far noise was taken for that of single pixels, from 0 to 1; the same everywhere. Policies that ask for it keep it where they report.
struct NoiseIndependence : ExactChannel<1> {
    static constexpr auto name = "noise_independence"; ///< of the channel
};
inline constexpr NoiseIndependence noise_independence; ///< of a history

namespace detail {

/// Over windows of the frame: how many have a part of shared noise that is less than `least`, less than the middle, and less than `most`;
/// and how many have any noise.
template <int its_fraction> struct SharedNoiseSums : ExactChannel<4> {
    static constexpr auto name = "shared_noise_sums";
    static constexpr int fraction = its_fraction;
};

/// Of one component of a window: sums of pixels, of those to the right and those below, and of products with them.
template <class Real> struct NeighbourSums {
    Real here = Real(0.f), right = Real(0.f), below = Real(0.f), square = Real(0.f), by_right = Real(0.f), by_below = Real(0.f);

    QUELL_KERNEL void add(Real own, Real beside, Real under, Real weight) {
        auto const weighted = own * weight;
        here = here + weighted, right = fma(beside, weight, right), below = fma(under, weight, below);
        square = fma(own, weighted, square), by_right = fma(beside, weighted, by_right), by_below = fma(under, weighted, by_below);
    }
};

/// Finds the part of each window.
/// @tparam Differences a channel whose first three components are what samples have more than a picture; 0 where that is not known
template <ChannelTag Differences> struct ShareOfNeighbours {
    static constexpr auto name = "shared noise";
    static constexpr int fraction = blocks_side;
    using reads = Channels<Differences>;
    using emits = Channels<SharedNoiseSums<fraction>>;
    static constexpr int farthest_tap = 1;
    SharedNoise rule;

    QUELL_KERNEL auto emit_channels(auto px) const {
        using Px = decltype(px);
        using Real = typename Px::Real;
        NeighbourSums<Real> x, y, z;
        vec3<Real> row[blocks_side + 1], below[blocks_side + 1];
        auto const take = [&](int j, vec3<Real>(&to)[blocks_side + 1]) QUELL_INLINED {
            for (int i = 0; i <= blocks_side; ++i) {
                auto const value = px.finer(Differences{}, i, j);
                to[i] = {component<0>(value), component<1>(value), component<2>(value)};
            }
        };
        Real pixels(0.f);
        auto const right = to_real(px.frame_size().width - 1), bottom = to_real(px.frame_size().height - 1);
        take(0, below);
        for (int j = 0; j < blocks_side; ++j) {
            for (int i = 0; i <= blocks_side; ++i) row[i] = below[i];
            take(j + 1, below);
            for (int i = 0; i < blocks_side; ++i) {
                auto const column = px.columns() * static_cast<float>(blocks_side) + static_cast<float>(i);
                auto const its_row = px.row_of_lanes() * static_cast<float>(blocks_side) + static_cast<float>(j);
                auto const weight = masked(both(column < Real(right), its_row < Real(bottom)), Real(1.f));
                pixels = pixels + weight;
                x.add(row[i].x, row[i + 1].x, below[i].x, weight), y.add(row[i].y, row[i + 1].y, below[i].y, weight);
                z.add(row[i].z, row[i + 1].z, below[i].z, weight);
            }
        }
        auto const per_pixel = 1.f / max(pixels, Real(1.f));
        auto const all = [&](auto const& of) QUELL_INLINED { return of(x) + of(y) + of(z); };
        using Sums = NeighbourSums<Real>;
        auto const raw = all([](Sums const& s) QUELL_INLINED { return s.square; });
        auto const square = all([&](Sums const& s) QUELL_INLINED { return s.square - s.here * s.here * per_pixel; });
        auto const by_right = all([&](Sums const& s) QUELL_INLINED { return s.by_right - s.here * s.right * per_pixel; });
        auto const by_below = all([&](Sums const& s) QUELL_INLINED { return s.by_below - s.here * s.below * per_pixel; });
        // Where a picture lacks the same everywhere, rounding is all that is left.
        auto const counts = square > raw * 1e-5f;
        auto const part = min(by_right, by_below) / max(square, Real(1e-30f));
        auto const below_limit = [&](float limit) QUELL_INLINED { return masked(both(counts, part < Real(limit)), Real(1.f)); };
        return emitted<Real>(SharedNoiseSums<fraction>{},
                             Value<4, Real>{below_limit(rule.least), below_limit(.5f * (rule.least + rule.most)), below_limit(rule.most),
                                            masked(counts, Real(1.f))});
    }
};

/// Passes that find how far noise may be taken for that of single pixels.
template <ChannelTag Differences> struct FindSharedNoise {
    using parts = Parts<ShareOfNeighbours<Differences>, SumFrame<SharedNoiseSums>>;
    using whole = Channels<SharedNoiseSums<whole_frame>>; ///< what those that go by it read
    SharedNoise rule;

    constexpr void for_each_pass(auto&& pass) const {
        pass(ShareOfNeighbours<Differences>{rule});
        SumFrame<SharedNoiseSums>{}.for_each_pass(pass);
    }
};

/// How far noise may be taken for that of single pixels: 1, and down to 0 where it is shared. With q the quartile from below of all
/// windows' parts, 1 up to `least`, and 0 from `most` on; in between, the distribution of parts is taken for two straight lines.
template <class Px> QUELL_KERNEL auto independence(Px const& px) {
    using Real = typename Px::Real;
    auto const sums = px.coarser(SharedNoiseSums<whole_frame>{});
    auto const quarter = sums.w * .25f;
    auto const along = [&](Real from, Real to) QUELL_INLINED { // where a quarter is reached between two limits: 0 to 1
        return clamp((quarter - from) / max(to - from, Real(1e-6f)), Real(0.f), Real(1.f));
    };
    return 1.f - .5f * (along(sums.x, sums.y) + along(sums.y, sums.z));
}

} // namespace detail

} // namespace quell::inline QUELL_INSTRUCTION_SET
