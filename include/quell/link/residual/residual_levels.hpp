#pragma once

#include <quell/filter/edge_weights.hpp>
#include <quell/filter/wavelet_taps.hpp>
#include <quell/link/residual/residual.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Logarithms of the picture's light: of the pixel's own, and of that around it.
struct LightLogarithms : InternalChannel<2> {
    static constexpr auto name = "light_logarithms";
    static constexpr bool full_precision = true;
};
/// Each half of a checkerboard's residual smoothed, and which part of a pixel's weights that half has.
struct FirstHalf : InternalChannel<4> {
    static constexpr auto name = "first_half";
    static constexpr bool full_precision = true;
};
struct SecondHalf : InternalChannel<4> {
    static constexpr auto name = "second_half";
    static constexpr bool full_precision = true;
};

/// Neighbours of another light weigh less: exp(-|dl| / sigma), with l its logarithm.
struct LightLogarithmEdge {
    using reads = Channels<LightLogarithms>;
    static constexpr int farthest_tap = 0;
    float sigma = .2f; ///< difference with weight 1/e

    template <class Real> struct Around {
        Real centre;
        float per_sigma;
        QUELL_KERNEL Real distance(auto neighbour, Real sum) const {
            return fma(abs(neighbour.template channel_component<0>(LightLogarithms{}) - centre), Real(per_sigma), sum);
        }
    };
    QUELL_KERNEL auto around(auto px) const {
        return Around<typename decltype(px)::Real>{px.template channel_component<0>(LightLogarithms{}), 1.f / sigma};
    }
};

/// What a residual is not smoothed across: borders of surfaces, and of pieces of like light.
using ResidualEdge = Product<DepthEdge, NormalEdge, LightLogarithmEdge>;

/// Smooths both halves of a residual over surfaces by a B-spline's 5x5 taps.
template <class Edge> struct SmoothHalves {
    static constexpr auto name = "smooth residual";
    using parts = Parts<Edge>;
    using reads = Channels<FirstHalf, SecondHalf>;
    using emits = reads;
    Edge edge;
    int step;

    constexpr int farthest_tap() const { return 2 * step; }

    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        using Taps = SplineTaps<CubicSpline>;
        auto const around = edge.around(px);
        auto first = scale(px[FirstHalf{}], Real(Taps::centre)), second = scale(px[SecondHalf{}], Real(Taps::centre));
        Real whole(Taps::centre);
        for_each_edge_tap<false, Taps::radius>(px, step, around, [&](auto const& tap) QUELL_INLINED {
            auto const weight = tap.weight(Taps::at(tap.column, tap.row));
            first = add_scaled(first, tap.px[FirstHalf{}], weight), second = add_scaled(second, tap.px[SecondHalf{}], weight);
            whole = whole + weight;
        });
        auto const per_whole = 1.f / whole;
        return emitted<Real>(FirstHalf{}, scale(first, per_whole)).with(SecondHalf{}, scale(second, per_whole));
    }
};

/// The residual smoothed, of all samples.
template <class Px> QUELL_KERNEL auto smoothed(Px const& px) {
    using Real = typename Px::Real;
    auto const both_halves = add_scaled(px[FirstHalf{}], px[SecondHalf{}], Real(1.f));
    return scale(colour_of(both_halves), 1.f / max(both_halves.w, Real(1e-6f)));
}
/// The same of samples of the checkerboard's other half. Where next to none of these is of this surface, nothing is known.
template <class Px> QUELL_KERNEL auto smoothed_of_others(Px const& px) {
    using Real = typename Px::Real;
    auto const others = select(checkerboard_half(px) > Real(0.5f), px[FirstHalf{}], px[SecondHalf{}]);
    return scale(colour_of(others), masked(others.w > Real(.02f), 1.f / max(others.w, Real(.02f))));
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
