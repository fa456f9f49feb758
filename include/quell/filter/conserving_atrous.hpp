#pragma once

#include <quell/filter/atrous.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {
/// The variance of each pixel's mean: over time where the history is long, over 3x3 pixels where it is short, and mixed in between.
template <class Edge> struct VarianceOfMean {
    static constexpr auto name = "variance of mean";
    using parts = Parts<Edge>;
    using reads = Channels<HistoryLength, LuminanceVariance>;
    using emits = Channels<Variance>;
    static constexpr int farthest_tap = 1;
    Edge edge;
    float enough;

    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const n = max(px[history_length], Real(1.f));
        // The variance over time is too small by (n - 1) / n, and the mean's is 1 / n of the samples'.
        auto const over_time = px[luminance_variance] / max(n - 1.f, Real(1.f));
        auto const brief = n < Real(enough);
        if (!any(brief)) return emitted<Real>(variance, over_time);
        auto const share = min((n - 1.f) / max(enough - 1.f, 1.f), Real(1.f));
        auto const mixed = mix(spatial_variance(px, over_time), over_time, share);
        return emitted<Real>(variance, select(both(brief, is_finite(mixed)), mixed, over_time));
    }

private:
    static constexpr int radius = 1, side = 2 * radius + 1;
    /// The minimum of four noisy estimates is too small; this makes up for it.
    static constexpr float minimum_correction = 2.f;

    /// What spatial_variance() compares.
    template <class Real> struct Window {
        Real light[side][side];  ///< luminance, by row and column
        Real weight[side][side]; ///< 0 where nothing was ever sampled
    };

    /// Half the mean square difference of neighbours, in the direction with the least: row, column or diagonal. Along a shadow's edge there
    /// is only noise; the variance of the whole neighbourhood would include the edge. Not inlined: few histories are short.
    template <class Px> QUELL_OUTLINED constexpr auto spatial_variance(Px const& px, typename Px::Real otherwise) const {
        using Real = typename Px::Real;
        auto const window = window_around(px);
        constexpr int right[] = {1, 0, 1, -1}, down[] = {0, 1, 1, 1}, directions = 4;
        Real squares[directions], weights[directions];
        for (int k = 0; k < directions; ++k) squares[k] = weights[k] = Real(0.f);
        QUELL_UNROLL
        for (int j = 0; j < side; ++j) {
            QUELL_UNROLL
            for (int i = 0; i < side; ++i) {
                QUELL_UNROLL
                for (int k = 0; k < directions; ++k) {
                    int const x = i + right[k], y = j + down[k];
                    if (x < 0 || x >= side || y >= side) continue;
                    auto const off = window.light[y][x] - window.light[j][i], w = window.weight[j][i] * window.weight[y][x];
                    squares[k] = fma(off * off, w, squares[k]);
                    weights[k] = weights[k] + w;
                }
            }
        }
        Real minimum(1e30f);
        for (int k = 0; k < directions; ++k) {
            // A total weight under 1/20 of a pair is no evidence.
            auto const known = weights[k] > Real(0.05f);
            minimum = select(known, min(minimum, squares[k] / select(known, weights[k], Real(1.f))), minimum);
        }
        return select(minimum < Real(1e30f), minimum * (0.5f * minimum_correction), otherwise);
    }
    template <class Px> QUELL_KERNEL auto window_around(Px const& px) const {
        using Real = typename Px::Real;
        auto const around = edge.around(px);
        Window<Real> window;
        auto const keep = [&](auto const& there, Real w, int i, int j) QUELL_INLINED {
            window.light[radius + j][radius + i] = luminance(there.signal());
            window.weight[radius + j][radius + i] = w * min(there[history_length], Real(1.f));
        };
        keep(px, Real(1.f), 0, 0);
        for_each_edge_tap<false, radius>(
            px, 1, around, [&](auto const& tap) QUELL_INLINED { keep(tap.px, tap.weight(WeightBits::of(1.f)), tap.column, tap.row); });
        return window;
    }
};

/// One level of ConservingAtrous.
template <class Edge> struct ExchangeLevel {
    static constexpr auto name = "conserving a-trous";
    using parts = Parts<Edge>;
    using reads = Channels<Variance>;
    using emits = Channels<Variance>;
    Edge edge;
    int step;
    float sigma_luminance;
    NearestTaps taps;

    constexpr int farthest_tap() const { return step; }

    QUELL_KERNEL auto filter(auto px) const {
        using Px = decltype(px);
        using Real = typename Px::Real;
        auto const around = edge.around(px);
        auto const here = px.signal();
        auto const noise_here = px[variance];
        auto const light = luminance(here);
        // Differences under 1e-4 of the light are no edge.
        constexpr float rounding = 1e-8f;
        // Of less, nothing comes over: black beside light stays black, whatever the light's unit.
        constexpr float hardly = 0x1p-24f;
        Real const sigma_squared(sigma_luminance * sigma_luminance);
        auto const tolerated = max(noise_here, light * light * rounding) * sigma_squared;
        // Only weights of geometry are normalised. Normalising those of luminance would lose light.
        auto sum = zero<typename Px::Signal>();
        Real weights(taps.centre), taken(0.f), noise(0.f);
        for_each_edge_tap<true, 1>(px, step, around, [&](auto const& tap) QUELL_INLINED {
            auto const known = taps.at(tap.column, tap.row);
            weights = weights + tap.weight(known);
            auto const there = tap.px.signal();
            auto const its_noise = tap.px[variance];
            // Symmetric in the two pixels: what one gives the other gets.
            auto const inverse = approximate_inverse_sqrt(fma(its_noise, sigma_squared, tolerated));
            auto const weight = tap.weight(known, fma(abs(luminance_plus(there, -light)), inverse, tap.distance));
            auto const w = masked(weight > Real(hardly), weight);
            sum = add_scaled(sum, there, w);
            taken = taken + w;
            noise = fma(its_noise, w * w, noise);
        });
        // Among equal pixels, a pixel gives all of itself away, but never more, whatever the weights are: the result lies between the taps.
        auto const part = 1.f / max(weights * (1.f - taps.centre), taken);
        auto const kept = max(1.f - taken * part, Real(0.f));
        auto const value = map([&](auto a, auto s) QUELL_INLINED { return fma(s, part, a * kept); }, here, sum);
        return Result{finite_or(value, here)}.with(variance, finite_or(fma(noise, part * part, noise_here * (kept * kept)), noise_here));
    }
};
} // namespace detail

/// A variance-guided a-trous wavelet (after Schied et al. 2017) that conserves light. Goes after a Temporal{motion, WithVariance{...}}
/// whose policy keeps the history length.
///
/// The usual filter averages the neighbours that look alike. With the skewed noise of path tracing, most pixels are darker than the mean
/// and find each other, so light is lost. Here pixels exchange light in pairs: out(p) = in(p) + sum of w(p, q) (in(q) - in(p)). w is the
/// same from both sides, since differences are measured against the noise of both pixels, so what one loses the other gains. Exact inside a
/// surface; at edges of geometry the weights are normalised per pixel. Taps are those of LinearThenBox.
/// @tparam Edge an EdgeWeight for geometry; the one for luminance is built in
template <class Edge = Product<DepthEdge, NormalEdge>> struct ConservingAtrous {
    static_assert(EdgeWeight<Edge>, "ConservingAtrous{edge}: `edge` must have around(px), see quell/filter/filter_kernel.hpp");
    /// @cond
    using Level = detail::ExchangeLevel<Edge>;
    using parts = Parts<detail::VarianceOfMean<Edge>, Level>;
    /// @endcond
    Edge edge{};                  ///< which neighbours belong to the same surface
    int levels = 4;               ///< passes, with taps 1, 2, 5, 12, 30, ... pixels apart
    float sigma_luminance = 3.2f; ///< difference with weight 1/e, in standard deviations of the noise of both pixels
    float sigma_first = 6.f;      ///< the same for the first level, whose input is noisier
    float enough = 4.f;           ///< history length from which the variance over time is trusted; 0 with KnownSamples{}

    /// The variance, then one pass per level.
    constexpr void for_each_pass(auto&& pass) const {
        pass(detail::VarianceOfMean<Edge>{edge, enough});
        detail::for_each_level<LinearThenBox>(levels, 1, [&](int i, int step, auto taps) {
            pass(Level{edge, step, i == 0 ? sigma_first : sigma_luminance, taps});
        });
    }
};
template <class... Fields>
ConservingAtrous(Fields...) -> ConservingAtrous<typename detail::EdgeAmong<Product<DepthEdge, NormalEdge>, Fields...>::type>;

} // namespace quell::inline QUELL_INSTRUCTION_SET
