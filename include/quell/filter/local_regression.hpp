#pragma once

#include <quell/filter/conserving_atrous.hpp>
#include <quell/filter/least_squares.hpp>
#include <quell/filter/restore_light.hpp>
#include <quell/frame/hull.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// The accumulated light after `level` levels of the pilot; 0: before the pilot.
/// @tparam n the signal's components
template <int level, int n> struct LessFilteredLight : InternalChannel<n> { static constexpr auto name = "less_filtered_light"; };
/// The variance of the accumulated light's luminance, before any filter.
struct UnfilteredVariance : InternalChannel<1> {
    /// @cond
    static constexpr auto name = "unfiltered_variance";
    static constexpr bool squared = true;
    /// @endcond
};
inline constexpr UnfilteredVariance unfiltered_variance;
namespace detail {
/// Copies the signal for the fit; level 0 also copies its variance.
template <int level, int n> struct KeepLight {
    static constexpr auto name = "keep light";
    using Light = LessFilteredLight<level, n>;
    using reads = std::conditional_t<level == 0, Channels<Variance>, Channels<>>;
    using emits = std::conditional_t<level == 0, Channels<Light, UnfilteredVariance>, Channels<Light>>;
    static constexpr int farthest_tap = 0;

    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const light = emitted<Real>(Light{}, px.signal());
        if constexpr (level == 0)
            return light.with(unfiltered_variance, px[variance]);
        else
            return light;
    }
};

/// The largest difference of any component.
template <class V> QUELL_KERNEL auto largest_difference(V const& a, V const& b) {
    return [&]<int... c>(std::integer_sequence<int, c...>) QUELL_INLINED {
        auto maximum = abs(component<0>(a) - component<0>(b));
        ((maximum = max(maximum, abs(component<c>(a) - component<c>(b)))), ...);
        return maximum;
    }
    (std::make_integer_sequence<int, components_of<V>>{});
}

/// The fit of LocalRegression.
template <class Edge, int n> struct RegressionOnGuides {
    static constexpr auto name = "local regression";
    static constexpr int farthest_tap = 24;
    template <int level> using Light = LessFilteredLight<level, n>;
    using parts = Parts<Edge>;
    using reads = Channels<Normal, HistoryLength, Variance, UnfilteredVariance, Light<0>, Light<1>, Light<2>>;
    using emits = Channels<LightOfPilotAndFit, FreedomOfFit>;
    Edge edge;
    float width, min_width, max_width, tolerance, sigma_light, sigma_noise;

    QUELL_KERNEL auto filter(auto px) const {
        using Px = decltype(px);
        using Real = typename Px::Real;
        auto const pilot = px.signal();
        auto const noise = deviation_around(px);
        Centre<Px, decltype(edge.around(px))> const centre{
            px, edge.around(px), pilot, px[normal], px[variance], noise, inverse_square_width(noise, luminance(pilot))};
        Window<typename Px::Signal> window{{}, Hull<typename Px::Signal>(pilot)};
        add_ring<0>(centre, window, 0, 2, 1);
        add_ring<1>(centre, window, 3, 9, 3);
        add_ring<2>(centre, window, 12, 24, 6);
        constexpr float ridge[] = {0.02f, 0.02f, 2e-5f, 2e-5f, 2e-5f};
        auto const value = window.fit.constant(ridge);
        auto const known = both(window.fit.weights > Real(1e-6f), all_finite(value));
        auto const result = select(known, window.seen.limited(value), pilot);
        return Result{result}
            .with(light_of_pilot_and_fit, vec2<Real>{luminance(pilot), luminance(result)})
            .with(freedom_of_fit, select(known, freedom(result, window.seen), Real(1.f)));
    }

private:
    template <class Px, class Around> struct Centre {
        using Real = typename Px::Real;
        Px const& px;
        Around around;
        typename Px::Signal pilot;
        vec3<Real> n_here;
        Real pilot_variance, noise, per_square;
    };
    /// What a fit is of, and the range of its values.
    template <class V> struct Window {
        LeastSquares<V> fit;
        Hull<V> seen;
    };
    /// See FreedomOfFit.
    template <class V> QUELL_KERNEL static auto freedom(V const& value, Hull<V> const& seen) {
        using Real = real_of<V>;
        auto const of_component = [](Real a, Real low, Real high) QUELL_INLINED {
            // Away from 0 and towards it, for both signs.
            auto const size = max(abs(a), Real(1e-20f)), farther = select(a < Real(0.f), -low, high),
                       nearer = select(a < Real(0.f), -high, low);
            return min(farther / size, size / max(nearer, Real(1e-20f)));
        };
        auto const each = map(of_component, value, seen.low, seen.high);
        return fold([](auto least, auto a) QUELL_INLINED { return min(least, a); }, Real(2.f), each);
    }

    /// Standard deviation of the accumulated light, over 5x5 pixels.
    template <class Px> QUELL_KERNEL static auto deviation_around(Px const& px) {
        using Real = typename Px::Real;
        Real sum(0.f), count(0.f);
        for_each_neighbour<2>(px, [&](auto const& neighbour, auto inside, int, int) QUELL_INLINED {
            sum = fma(neighbour[unfiltered_variance], inside, sum);
            count = count + inside;
        });
        return sqrt(sum / count);
    }
    /// 1 / w^2, where w is the width of the window in pixels. w grows with the cube root of the relative noise: this balances variance
    /// against the curvature that a linear fit misses.
    template <class Real> QUELL_KERNEL Real inverse_square_width(Real noise, Real light) const {
        auto const relative = clamp(noise / max(light, Real(1e-12f)), Real(1e-6f), Real(1e6f));
        // Cube root to a few percent: a third of the exponent.
        auto const root = from_bits(truncate(fma(to_real(bits(relative)), Real(1.f / 3.f), Real(709921077.f))));
        auto const w = clamp(root * width, Real(min_width), Real(max_width));
        return 1.f / (w * w);
    }
    /// Adds a square ring of taps. Each stands for stride x stride pixels, and reads light filtered about that wide.
    template <int level, class C, class W> QUELL_KERNEL void add_ring(C const& centre, W& window, int inner, int outer, int stride) const {
        auto const area = WeightBits::of(static_cast<float>(stride * stride));
        for (int dy = -outer; dy <= outer; dy += stride) {
            auto const beside = centre.px.at(0, dy);
            if (!beside.row_inside) continue;
            bool const across = dy <= -inner || dy >= inner;
            for (int dx = -outer; dx <= outer; dx += stride)
                if (across || dx <= -inner || dx >= inner) add_tap<level>(centre, window, dx, dy, area);
        }
    }
    template <int level, class C, class W> QUELL_KERNEL void add_tap(C const& centre, W& window, int dx, int dy, WeightBits area) const {
        using Real = typename C::Real;
        auto const tap = centre.px.at(dx, dy);
        float const across = static_cast<float>(dx), down = static_cast<float>(dy);
        auto const start = select(
            tap.inside(), fma(centre.per_square, Real(across * across + down * down), Real(edge_offset(centre.around))), Real(too_far));
        auto distance = edge_toward(centre.around, dx, dy).distance(tap, start);
        // The pilot is compared, not the samples that are weighed: weights that depend on them bias the fit.
        auto const there = tap.signal();
        auto const of_pilot = sqrt(centre.pilot_variance + tap[variance]) * sigma_light;
        auto const allowed =
            fma(abs(luminance(centre.pilot) + luminance(there)), Real(tolerance), fma(centre.noise, Real(sigma_noise), of_pilot));
        distance = fma(largest_difference(there, centre.pilot), 1.f / (allowed + 1e-20f), distance);
        auto const w = edge_weight(distance, area) * min(tap[history_length], Real(1e4f));
        auto const n_there = tap[normal];
        Real const at[] = {Real(across / 12.f), Real(down / 12.f), n_there.x - centre.n_here.x, n_there.y - centre.n_here.y,
                           n_there.z - centre.n_here.z};
        auto const light = tap[Light<level>{}];
        window.fit.add(at, light, w);
        // Less is of another surface, or outside the image.
        window.seen.add(light, w > Real(1e-9f));
    }
};

/// Slopes need differing normals, so the default edge is 16 times looser on them than NormalEdge.
template <class Edge> constexpr Edge loose_edge() {
    if constexpr (std::is_same_v<Edge, Product<DepthEdge, NormalEdge>>)
        return {DepthEdge{}, NormalEdge{.sharpness = 8.f}};
    else
        return {};
}
} // namespace detail

/// First-order regression on guides (after Moon et al. 2014 and Bitterli et al. 2016). In a window around each pixel, fits the accumulated
/// light by a linear function of pixel position and normal, and takes its value at the pixel. This does not blur gradients, curved surfaces
/// and antialiased edges, as means do.
///
/// A ConservingAtrous runs first; its result is the pilot. Taps weigh by geometry and by their difference in the pilot. The window is 49x49
/// pixels at most, with 145 taps: 5x5, and two sparse rings that read light of the pilot's first levels. Its width follows the noise.
/// Finally the fit is scaled to the pilot's luminance over 25x25 pixels, so that no light is lost: with skewed noise, pixels that look
/// alike are darker than their surroundings.
///
/// For offline use: it costs several times the pilot. Like ConservingAtrous it goes after a Temporal{motion, WithVariance{...}} whose
/// policy keeps the history length.
/// @tparam Edge an EdgeWeight for geometry; keep it loose on normals, which are regressors
/// @tparam n    the signal's components
template <class Edge = Product<DepthEdge, NormalEdge>, int n = 3> struct LocalRegression {
    static_assert(EdgeWeight<Edge>, "LocalRegression{...}: `edge` must have around(px), see quell/filter/filter_kernel.hpp");
    /// @cond
    using Fit = detail::RegressionOnGuides<Edge, n>;
    using parts = Parts<ConservingAtrous<>, detail::KeepLight<0, n>, detail::KeepLight<1, n>, detail::KeepLight<2, n>, Fit>;
    /// @endcond
    ConservingAtrous<> pilot{};             ///< runs first
    Edge edge = detail::loose_edge<Edge>(); ///< which neighbours belong to the same surface
    float width = 25.f;                     ///< distance in pixels at which taps have weight 1/e where the noise is as large as the light
    float min_width = 4.f;                  ///< minimum of that distance
    float max_width = 24.f;                 ///< maximum of that distance
    float tolerance = 0.0125f;              ///< difference in the pilot with weight 1/e is the sum of: this part of both pixels' luminance,
    float sigma_light = 1.f;                ///< this many standard deviations of the pilot's noise,
    float sigma_noise = 0.2f;               ///< and this many of the accumulated light's noise

    /// The pilot's passes, the fit, and the scaling to the pilot's luminance.
    constexpr void for_each_pass(auto&& pass) const {
        int done = 0;
        auto const keep_light = [&] {
            if (done == 0) pass(detail::KeepLight<0, n>{});
            if (done == 1) pass(detail::KeepLight<1, n>{});
            if (done == 2) pass(detail::KeepLight<2, n>{});
            ++done;
        };
        pilot.for_each_pass([&](auto const& kernel) { pass(kernel), keep_light(); });
        while (done <= 2) keep_light();
        pass(Fit{edge, width, min_width, max_width, tolerance, sigma_light, sigma_noise});
        for (int const step : {1, 5}) {
            pass(detail::LightLine{step, false});
            pass(detail::LightLine{step, true});
        }
        pass(detail::RestoreLight{});
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
