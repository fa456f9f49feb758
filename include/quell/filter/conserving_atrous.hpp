#pragma once

#include <quell/filter/atrous.hpp>

namespace quell {

namespace detail {
/// The variance of each pixel's mean. Over time where the history is long, from the 5x5 around where it is short, and in between both.
template <class Edge> struct VarianceOfMean {
    static constexpr auto name = "variance of mean";
    using parts = Parts<Edge>;
    using reads = Channels<HistoryLength, LuminanceVariance>;
    using emits = Channels<Variance>;
    Edge edge;
    float enough;

    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const n = max(px[history_length], Real(1.f));
        // Of n samples, the squares of whose distances from their own mean come out too small by (n - 1) / n.
        auto const over_time = px[luminance_variance] / max(n - 1.f, Real(1.f));
        auto const brief = n < Real(enough);
        if (!any(brief)) return emitted<Real>(variance, over_time);
        auto const share = min((n - 1.f) / max(enough - 1.f, 1.f), Real(1.f));
        auto const mixed = mix(spatial_variance(px, over_time), over_time, share);
        return emitted<Real>(variance, select(both(brief, is_finite(mixed)), mixed, over_time));
    }

private:
    static constexpr int radius = 2, side = 2 * radius + 1;
    /// The least of four directions' is too small where there is nothing but noise; this makes up for it.
    static constexpr float least_of_four = 1.5f;

    /// Half the mean square difference of neighbours along a row, a column or a diagonal, whichever is least: along the edge of a shadow
    /// there is only noise, where the variance of all that is seen around would take the edge for it. Outlined: few histories are short.
    template <class Px> [[gnu::noinline]] constexpr auto spatial_variance(Px const& px, typename Px::Real otherwise) const {
        using Real = typename Px::Real;
        auto const around = edge.around(px);
        Real light[side][side], weight[side][side];
        for (int j = 0; j < side; ++j)
            for (int i = 0; i < side; ++i) {
                auto const there = px.at(i - radius, j - radius);
                auto const distance =
                    detail::edge_toward(around, i - radius, j - radius).distance(there, Real(detail::edge_offset(around)));
                auto const sampled = masked(there.inside(), min(there[history_length], Real(1.f)));
                light[j][i] = luminance(there.signal());
                weight[j][i] = i == radius && j == radius ? sampled : sampled * edge_weight(distance);
            }
        Real least(1e30f);
        for (auto const& [dx, dy] : {std::pair{1, 0}, std::pair{0, 1}, std::pair{1, 1}, std::pair{-1, 1}}) {
            Real squares(0.f), weights(0.f);
            for (int j = 0; j + dy < side; ++j)
                for (int i = max_of(-dx, 0); i + max_of(dx, 0) < side; ++i) {
                    auto const off = light[j + dy][i + dx] - light[j][i], w = weight[j][i] * weight[j + dy][i + dx];
                    squares = fma(off * off, w, squares);
                    weights = weights + w;
                }
            // Less than a twentieth of a pair is no evidence.
            auto const known = weights > Real(0.05f);
            least = select(known, min(least, squares / select(known, weights, Real(1.f))), least);
        }
        return select(least < Real(1e30f), least * (0.5f * least_of_four), otherwise);
    }
    static constexpr int max_of(int a, int b) { return a > b ? a : b; }
};

/// One level of an edge-avoiding wavelet by which pixels exchange light: see ConservingAtrous.
template <class Edge> struct ExchangeLevel {
    static constexpr auto name = "conserving a-trous";
    using parts = Parts<Edge>;
    using reads = Channels<Variance>;
    using emits = Channels<Variance>;
    Edge edge;
    int step;
    float sigma_luminance;
    float exchange;

    QUELL_KERNEL auto filter(auto px) const {
        using Px = decltype(px);
        using Real = typename Px::Real;
        constexpr float centre = LinearSpline::weights[0] * LinearSpline::weights[0];
        auto const around = edge.around(px);
        auto const here = px.signal();
        auto const brightness = luminance(here);
        auto const noise_here = px[variance];
        // Differences under a ten-thousandth of the light are no edge.
        constexpr float rounding = 1e-8f;
        auto const tolerated = fma(brightness * brightness, Real(rounding), noise_here + 1e-20f);
        // Geometry is certain and normalises; brightness is not, and doesn't.
        auto gained = zero<typename Px::Signal>();
        Real weights(centre), taken(0.f), noise(0.f);
        auto const exchanged = [&](auto const& neighbour, auto distance, float bits) QUELL_INLINED {
            weights = weights + edge_weight(distance, bits);
            auto const there = neighbour.signal();
            auto const its_noise = neighbour[variance];
            // Both sides see the same difference over the same noise, so that what one gives the other gets.
            auto const its_brightness = luminance(there);
            auto const of_both = fma(its_brightness * its_brightness, Real(rounding), tolerated + its_noise);
            distance = fma(abs(its_brightness - brightness), approximate_reciprocal(sqrt(of_both) * sigma_luminance), distance);
            auto const w = edge_weight(distance, bits);
            gained = map([&](auto sum, auto a, auto b) QUELL_INLINED { return fma(a - b, w, sum); }, gained, there, here);
            taken = taken + w;
            noise = fma(its_noise, w * w, noise);
        };
        for_each_edge_distance<true, 1>(
            px, step, around, [](int i, int j) QUELL_INLINED { return spline_bits<LinearSpline>.at[i][j]; }, exchanged);
        auto const part = exchange / weights;
        auto const kept = 1.f - taken * part;
        auto const value = map([&](auto a, auto g) QUELL_INLINED { return max(fma(g, part, a), Real(0.f)); }, here, gained);
        return Result{finite_or(value, here)}.with(variance, finite_or(fma(noise, part * part, noise_here * (kept * kept)), noise_here));
    }
};
} // namespace detail

/// A variance-guided a-trous wavelet (after Schied 2017) that conserves light. Other filters take a mean of those neighbours that look like
/// the pixel; where noise is skewed, as a path tracer's is, most pixels are darker than the mean and find each other, and light is lost.
/// Here pixels exchange light in pairs instead: out = in + sum of w(p, q) (in(q) - in(p)), where w is the same from both sides since
/// differences are measured against the noise of both. What one loses the other gains. The first level, which sees the noise as it is, asks
/// for more evidence of an edge than the others, which compare what is less noisy. 3x3 taps. Wants a Temporal{motion, WithVariance{...}}
/// before it, of a policy that keeps the history's length.
/// @tparam Edge an EdgeWeight for geometry; the weight for luminance is built in
template <class Edge = Product<DepthEdge, NormalEdge>> struct ConservingAtrous {
    static_assert(EdgeWeight<Edge>, "ConservingAtrous{edge}: `edge` must have around(px), see quell/filter/filter_kernel.hpp");
    using Level = detail::ExchangeLevel<Edge>;
    using parts = Parts<detail::VarianceOfMean<Edge>, Level>;
    Edge edge{};
    int levels = 5;
    float sigma_luminance = 4.f; ///< deviations of the noise of both pixels that they may differ by at weight 1/e
    float sigma_first = 6.f;     ///< the same for the first level
    float exchange = 1.2f;       ///< 1: a pixel keeps the spline's quarter of itself among equals; up to 1.33, where it keeps nothing
    float enough = 4.f;          ///< frames over which a variance is trusted; 0 where the host says the variance (KnownSamples{})

    constexpr void for_each_pass(auto&& pass) const {
        pass(detail::VarianceOfMean<Edge>{edge, enough});
        for (int i = 0; i < levels; ++i) pass(Level{edge, 1 << i, i == 0 ? sigma_first : sigma_luminance, exchange});
    }
};
template <class... Fields>
ConservingAtrous(Fields...) -> ConservingAtrous<typename detail::EdgeAmong<Product<DepthEdge, NormalEdge>, Fields...>::type>;

} // namespace quell
