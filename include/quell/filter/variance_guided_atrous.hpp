#pragma once

#include <quell/filter/atrous.hpp>

namespace quell {

namespace detail {
/// The variance that the wavelet starts from: that of the mean over the history, since this is what will be filtered (the samples' own
/// variance would let every penumbra blur as long as the filter reaches). Measured over time, or, while the history is short, over the 7x7
/// around.
template <class Edge> struct VarianceEstimate {
    static constexpr auto name = "variance estimate";
    using parts = Parts<Edge>;
    using reads = Channels<HistoryLength, LuminanceMean, LuminanceVariance>;
    using emits = Channels<Variance>;
    Edge edge;
    float enough = 4.f; ///< frames

    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const n = px[history_length];
        auto const temporal = px[luminance_variance] / max(n, Real(1.f));
        auto const brief = n < Real(enough);
        if (!any(brief)) return emitted<Real>(variance, temporal);
        auto const spatial = spatial_variance(px) / max(n, Real(1.f));
        return emitted<Real>(variance, select(brief, finite_or(spatial, temporal), temporal));
    }

private:
    /// Variance of a pixel in whose surroundings nothing was ever sampled: everything may flow in.
    static constexpr float unknown = 1e8f;

    /// Variance of everything seen around: each pixel's own, and how far the means lie apart. Distances from the centre don't cancel.
    /// Outlined: few histories are short.
    template <class Px> [[gnu::noinline]] constexpr auto spatial_variance(Px const& px) const {
        using Real = typename Px::Real;
        constexpr float box[4] = {1.f, 1.f, 1.f, 1.f};
        auto const around = edge.around(px);
        auto const centre = px[luminance_mean];
        Real weights(0.f), first(0.f), second(0.f);
        for_each_tap<3>(px, 1, box, [&](auto neighbour, auto inside, int dx, int dy) QUELL_INLINED {
            auto const sampled = min(neighbour[history_length], Real(1.f));
            auto const w =
                dx == 0 && dy == 0
                    ? inside * sampled
                    : inside * sampled *
                          edge_weight(detail::edge_toward(around, dx, dy).distance(neighbour, Real(detail::edge_offset(around))));
            auto const off = neighbour[luminance_mean] - centre;
            weights = weights + w;
            first = first + off * w;
            second = second + (off * off + neighbour[luminance_variance]) * w;
        });
        auto const known = weights > Real(0.f);
        auto const inverse = 1.f / select(known, weights, Real(1.f)), mean = first * inverse;
        return select(known, max(second * inverse - mean * mean, Real(0.f)), Real(unknown));
    }
};
} // namespace detail

/// Spatiotemporal variance-guided filtering's spatial half (Schied 2017): estimates the variance of each pixel's luminance, and runs an
/// a-trous wavelet that tells noise from edges by it. The first level's output is what history remembers. Wants a Temporal{motion,
/// WithMoments{...}} before it, of a policy that keeps the history's length.
/// @tparam Edge an EdgeWeight for geometry; the weight for luminance is built in
/// @tparam Spline CubicSpline, or LinearSpline for 3x3
template <class Edge = Product<DepthEdge, NormalEdge>, class Spline = CubicSpline> struct VarianceGuidedAtrous {
    static_assert(EdgeWeight<Edge>, "VarianceGuidedAtrous{edge}: `edge` must have around(px), see quell/filter/filter_kernel.hpp");
    using Guided = Product<Edge, VarianceGuidedEdge>;
    using Level = detail::AtrousLevel<Guided, true, Spline>;
    using parts = Parts<detail::VarianceEstimate<Edge>, Level>;
    Edge edge{};
    int levels = 5;
    float sigma_luminance = 3.f; ///< deviations of a pixel's mean that a neighbour may be off at weight 1/e; SVGF's 4 deviations of a
                                 ///< sample at alpha 0.2 are 1.33
    bool feedback = true;        ///< whether the first level's output becomes the history
    int first_step = 1;          ///< pixels between the taps of the first level; 2 behind a filter that has dealt with the nearest

    constexpr void for_each_pass(auto&& pass) const {
        pass(detail::VarianceEstimate<Edge>{edge});
        for (int i = 0; i < levels; ++i)
            pass(Level{Guided{edge, VarianceGuidedEdge{sigma_luminance}}, first_step << i, feedback && i == 0});
    }
};
template <class... Fields>
VarianceGuidedAtrous(Fields...) -> VarianceGuidedAtrous<typename detail::EdgeAmong<Product<DepthEdge, NormalEdge>, Fields...>::type>;

} // namespace quell
