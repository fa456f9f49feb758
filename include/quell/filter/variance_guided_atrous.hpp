#pragma once

#include <quell/filter/atrous.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {
/// The variance that the wavelet starts from: that of the accumulated mean. (The samples' own variance would blur every penumbra as far as
/// the filter reaches.) Measured over time, or over the 7x7 around while the history is short.
template <class Edge> struct VarianceEstimate {
    static constexpr auto name = "variance estimate";
    using parts = Parts<Edge>;
    using reads = Channels<HistoryLength, LuminanceMean, LuminanceVariance>;
    using emits = Channels<Variance>;
    static constexpr int farthest_tap = 3;
    Edge edge;
    float enough = 4.f; ///< history length from which the variance over time is trusted

    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const n = px[history_length];
        auto const temporal = px[luminance_variance] / max(n, Real(1.f));
        // Rounding leaves a mean of equal lengths just below them.
        auto const brief = n < Real(enough * 0.9999f);
        if (!any(brief)) return emitted<Real>(variance, temporal);
        auto const spatial = spatial_variance(px) / max(n, Real(1.f));
        return emitted<Real>(variance, select(brief, finite_or(spatial, temporal), temporal));
    }

private:
    /// Standard deviation where nothing around was ever sampled, as a multiple of the light that stands in there: every neighbour may flow
    /// in.
    static constexpr float unknown = 1e4f;

    /// Variance of all samples around: the pixels' own, plus that of their means. Differences from the centre do not cancel. Not inlined:
    /// few histories are short.
    template <class Px> QUELL_OUTLINED constexpr auto spatial_variance(Px const& px) const {
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
        auto const of_unknown = luminance(px.signal()) * unknown;
        return select(known, max(second * inverse - mean * mean, Real(0.f)), of_unknown * of_unknown);
    }
};
} // namespace detail

/// The spatial half of spatiotemporal variance-guided filtering (Schied et al. 2017). Estimates the variance of each pixel's luminance, and
/// runs an a-trous wavelet that tells noise from edges by it. Goes after a Temporal{motion, WithMoments{...}} whose policy keeps the
/// history length.
/// @tparam Edge   an EdgeWeight for geometry; the one for luminance is built in
/// @tparam Spline the taps: CubicSpline, LinearSpline or LinearThenBox
template <class Edge = Product<DepthEdge, NormalEdge>, class Spline = CubicSpline> struct VarianceGuidedAtrous {
    static_assert(EdgeWeight<Edge>, "VarianceGuidedAtrous{edge}: `edge` must have around(px), see quell/filter/filter_kernel.hpp");
    /// @cond
    using Guided = Product<Edge, VarianceGuidedEdge>;
    using Level = detail::AtrousLevel<Guided, true, detail::TapsOf<Spline>>;
    using parts = Parts<detail::VarianceEstimate<Edge>, Level>;
    /// @endcond
    Edge edge{};                 ///< which neighbours belong to the same surface
    int levels = 5;              ///< passes; the Spline says how far apart their taps are, as multiples of first_step
    float sigma_luminance = 3.f; ///< difference with weight 1/e, in standard deviations of the accumulated mean (w_l)
    bool feedback = true;        ///< the first level's output goes into the history
    int first_step = 1;          ///< pixels between the taps of the first level; 2 after a filter of the 3x3 around, such as ConeGather
    float first_tolerance = 1.f; ///< multiple of sigma_luminance in the first level, above 0: more where the variance is often too small

    /// The variance, then one pass per level.
    constexpr void for_each_pass(auto&& pass) const {
        pass(detail::VarianceEstimate<Edge>{edge});
        detail::for_each_level<Spline>(levels, first_step, [&](int i, int step, auto taps) {
            float const sigma = i == 0 ? sigma_luminance * first_tolerance : sigma_luminance;
            pass(Level{Guided{edge, VarianceGuidedEdge{sigma}}, step, taps, feedback && i == 0});
        });
    }
};
template <class... Fields>
VarianceGuidedAtrous(Fields...) -> VarianceGuidedAtrous<typename detail::EdgeAmong<Product<DepthEdge, NormalEdge>, Fields...>::type>;

} // namespace quell::inline QUELL_INSTRUCTION_SET
