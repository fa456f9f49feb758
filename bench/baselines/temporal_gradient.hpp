#pragma once

#include <quell/blend/part_of_past.hpp>
#include <quell/filter/edge_weights.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Temporal gradient at a pixel, as means over its surroundings. x: luminance now minus luminance in the previous frame. y: the larger of
/// the two.
struct FilteredGradient : InternalChannel<2> {
    static constexpr auto name = "filtered_gradient";
};
inline constexpr FilteredGradient filtered_gradient;

namespace detail {
/// One level of a wavelet over the gradients. The first one gathers the single samples of the 3x3 strata.
template <class Source, class Edge> struct GradientLevel {
    static constexpr auto name = "temporal gradient";
    using parts = Parts<Edge>;
    using reads = Channels<Source>;
    using emits = Channels<FilteredGradient>;
    Edge edge;
    int step;

    constexpr int farthest_tap() const { return 2 * step; }

    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const around = edge.around(px);
        auto sum = px[Source{}];
        sum = select(all_finite(sum), sum, zero<vec2<Real>>());
        Real weights(1.f);
        for_each_edge_tap<false, 2>(px, step, around, [&](auto const& tap) QUELL_INLINED {
            auto const there = tap.px[Source{}];
            auto const usable = masked(all_finite(there), tap.weight(WeightBits::of(1.f)));
            sum = add_scaled(sum, select(all_finite(there), there, zero<vec2<Real>>()), usable);
            weights = weights + usable;
        });
        return emitted<Real>(filtered_gradient, scale(sum, 1.f / weights));
    }
};
} // namespace detail

/// Spreads gradient samples, of which the host gives one per 3x3 stratum, to all pixels (Schied et al. 2018). Goes before a Temporal{...,
/// Antilag{...}}.
/// @tparam Signal the signal whose gradient the host supplies, as GradientOf<Signal>
/// @tparam Edge   an EdgeWeight
template <ChannelTag Signal, class Edge = DepthEdge> struct TemporalGradient {
    static_assert(EdgeWeight<Edge>, "TemporalGradient{edge}: `edge` must have around(px), see quell/filter/filter_kernel.hpp");
    using parts = Parts<Edge>;
    using reads = Channels<GradientOf<Signal>>;
    using emits = Channels<FilteredGradient>;
    static constexpr bool leaves_signal = true;
    Edge edge{};    ///< how far gradients spread
    int levels = 3; ///< further levels after the first; each doubles the reach

    /// One pass per level.
    constexpr void for_each_pass(auto&& pass) const {
        pass(detail::GradientLevel<GradientOf<Signal>, Edge>{edge, 1});
        for (int i = 0; i < levels; ++i) pass(detail::GradientLevel<FilteredGradient, Edge>{edge, 3 << i});
    }
};

/// Forgets history where the light itself has changed: alpha = (1 - lambda) alpha_0 + lambda, where alpha_0 is the inner policy's and
/// lambda = min(1, |x| / y) of FilteredGradient (Schied et al. 2018).
/// @tparam Inner a BlendPolicy
template <class Inner> struct Antilag {
    static_assert(BlendPolicy<Inner>, "Antilag{inner}: `inner` must have blend(px, past), see quell/blend/blend_policy.hpp");
    using parts = Parts<Inner>;
    using reads = Channels<FilteredGradient>;
    static constexpr int farthest_tap = 0;
    Inner inner{}; ///< says alpha_0

    /// The inner policy's result with alpha.
    QUELL_KERNEL auto blend(auto px, auto past) const {
        using Real = typename decltype(px)::Real;
        auto const gradient = px[filtered_gradient];
        auto const change = min(abs(gradient.x) / max(gradient.y, Real(1e-37f)), Real(1.f));
        return detail::blend_part_of_past(inner, px, past, 1.f - change);
    }
};
template <class Inner> Antilag(Inner) -> Antilag<Inner>;

} // namespace quell::inline QUELL_INSTRUCTION_SET
