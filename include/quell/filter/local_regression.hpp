#pragma once

#include <quell/filter/conserving_atrous.hpp>
#include <quell/filter/least_squares.hpp>

namespace quell {

/// The accumulated light after `level` levels of the filter that makes the pilot; 0: before it.
/// @tparam n the signal's components
template <int level, int n> struct LessFilteredLight : MadeChannel<n> { static constexpr auto name = "less_filtered_light"; };
/// The variance of the accumulated luminance before any filter.
struct UnfilteredVariance : MadeChannel<1> {
    static constexpr auto name = "unfiltered_variance";
    static constexpr bool squared = true;
};
inline constexpr UnfilteredVariance unfiltered_variance;
/// Means over a window of the luminance of the pilot, which has all of the light, and of the fit.
struct LightOfPilotAndFit : MadeChannel<2> {
    static constexpr auto name = "light_of_pilot_and_fit";
};
inline constexpr LightOfPilotAndFit light_of_pilot_and_fit;

namespace detail {
/// Keeps the signal, and at first its variance, for a later pass.
template <int level, int n> struct KeepLight {
    static constexpr auto name = "keep light";
    using Light = LessFilteredLight<level, n>;
    using reads = std::conditional_t<level == 0, Channels<Variance>, Channels<>>;
    using emits = std::conditional_t<level == 0, Channels<Light, UnfilteredVariance>, Channels<Light>>;

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
        auto most = abs(component<0>(a) - component<0>(b));
        ((most = max(most, abs(component<c>(a) - component<c>(b)))), ...);
        return most;
    }
    (std::make_integer_sequence<int, components_of<V>>{});
}

/// The fit itself: see LocalRegression.
template <class Edge, int n> struct RegressionOnGuides {
    static constexpr auto name = "local regression";
    template <int level> using Light = LessFilteredLight<level, n>;
    using parts = Parts<Edge>;
    using reads = Channels<Normal, HistoryLength, Variance, UnfilteredVariance, Light<0>, Light<1>, Light<2>>;
    using emits = Channels<LightOfPilotAndFit>;
    Edge edge;
    float width, least_width, most_width, tolerance, sigma_light, sigma_noise;

    QUELL_KERNEL auto filter(auto px) const {
        using Px = decltype(px);
        using Real = typename Px::Real;
        auto const pilot = px.signal();
        auto const noise = deviation_around(px);
        Centre<Px, decltype(edge.around(px))> const centre{
            px, edge.around(px), pilot, px[normal], px[variance], noise, nearness(noise, luminance(pilot))};
        LeastSquares<typename Px::Signal> fit;
        add_ring<0>(centre, fit, 0, 2, 1);
        add_ring<1>(centre, fit, 3, 9, 3);
        add_ring<2>(centre, fit, 12, 24, 6);
        constexpr float ridge[] = {0.02f, 0.02f, 2e-5f, 2e-5f, 2e-5f};
        auto const value = map([](auto a) QUELL_INLINED { return max(a, Real(0.f)); }, fit.constant(ridge));
        auto const known = both(fit.weights > Real(1e-6f), all_finite(value));
        auto const result = select(known, value, pilot);
        return Result{result}.with(light_of_pilot_and_fit, vec2<Real>{luminance(pilot), luminance(result)});
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
    /// 1 / w^2, where w is the width of the window in pixels: it grows with the cube root of the relative noise, which balances variance
    /// against the curvature that a linear fit does not follow.
    template <class Real> QUELL_KERNEL Real nearness(Real noise, Real light) const {
        auto const relative = clamp(noise / max(light, Real(1e-12f)), Real(1e-6f), Real(1e6f));
        // The cube root by a third of the exponent, to a few percent.
        auto const root = from_bits(truncate(fma(to_real(bits(relative)), Real(1.f / 3.f), Real(709921077.f))));
        auto const w = clamp(root * width, Real(least_width), Real(most_width));
        return 1.f / (w * w);
    }
    /// Adds the taps of a square ring, each of which stands for stride x stride pixels and reads light that was filtered about as wide.
    template <int level, class C, class Fit> QUELL_KERNEL void add_ring(C const& centre, Fit& fit, int inner, int outer, int stride) const {
        float const area = weight_bits(static_cast<float>(stride * stride));
        for (int dy = -outer; dy <= outer; dy += stride) {
            auto const beside = centre.px.at(0, dy);
            if (!beside.row_inside) continue;
            bool const across = dy <= -inner || dy >= inner;
            for (int dx = -outer; dx <= outer; dx += stride)
                if (across || dx <= -inner || dx >= inner) add_tap<level>(centre, fit, dx, dy, area);
        }
    }
    template <int level, class C, class Fit> QUELL_KERNEL void add_tap(C const& centre, Fit& fit, int dx, int dy, float area) const {
        using Real = typename C::Real;
        auto const tap = centre.px.at(dx, dy);
        float const across = static_cast<float>(dx), down = static_cast<float>(dy);
        auto const start = select(
            tap.inside(), fma(centre.per_square, Real(across * across + down * down), Real(edge_offset(centre.around))), Real(too_far));
        auto distance = edge_toward(centre.around, dx, dy).distance(tap, start);
        // Light is compared in the pilot, which does not look at the samples that are weighed.
        auto const there = tap.signal();
        auto const of_pilot = sqrt(centre.pilot_variance + tap[variance]) * sigma_light;
        auto const allowed =
            fma(luminance(centre.pilot) + luminance(there), Real(tolerance), fma(centre.noise, Real(sigma_noise), of_pilot));
        distance = fma(largest_difference(there, centre.pilot), 1.f / (allowed + 1e-20f), distance);
        auto const w = edge_weight(distance, area) * min(tap[history_length], Real(1e4f));
        auto const n_there = tap[normal];
        Real const at[] = {Real(across / 12.f), Real(down / 12.f), n_there.x - centre.n_here.x, n_there.y - centre.n_here.y,
                           n_there.z - centre.n_here.z};
        fit.add(at, tap[Light<level>{}], w);
    }
};

/// Puts together five in a row or a column.
struct LightLine {
    static constexpr auto name = "light of pilot and fit";
    using reads = Channels<LightOfPilotAndFit>;
    using emits = Channels<LightOfPilotAndFit>;
    int step;
    bool vertical;

    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        Real pilot(0.f), fit(0.f);
        for_each_of_five(px, step, vertical, [&](auto const& neighbour, auto inside) QUELL_INLINED {
            auto const light = neighbour[light_of_pilot_and_fit];
            pilot = pilot + masked(inside, light.x);
            fit = fit + masked(inside, light.y);
        });
        return emitted<Real>(light_of_pilot_and_fit, vec2<Real>{pilot * 0.2f, fit * 0.2f});
    }
};
/// Gives the fit as much light as the pilot has around.
struct RestoreLight {
    static constexpr auto name = "restore light";
    using reads = Channels<LightOfPilotAndFit>;

    QUELL_KERNEL auto filter(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const light = px[light_of_pilot_and_fit];
        auto const factor = clamp(light.x / max(light.y, Real(1e-20f)), Real(0.5f), Real(2.f));
        return Result{finite_or(scale(px.signal(), factor), px.signal())};
    }
};

/// Slopes show only where normals differ, so the edge of normals is sixteen times less sharp than that of other filters.
template <class Edge> constexpr Edge loose_edge() {
    if constexpr (std::is_same_v<Edge, Product<DepthEdge, NormalEdge>>)
        return {DepthEdge{}, NormalEdge{.sharpness = 8.f}};
    else
        return {};
}
} // namespace detail

/// Fits, in a window around each pixel, the accumulated light by a linear function of the place on the screen and of the normal, and takes
/// its value at the pixel (first-order regression on guides; after Moon et al. 2014 and Bitterli et al. 2016). Where means blur, along
/// gradients, on curved surfaces and over edges that pixels mix, a linear function does not. Neighbours weigh by geometry and by how much
/// the light differs in a pilot: the result of ConservingAtrous, which runs first. The window is as wide as there is noise, of 145 taps:
/// 5x5, and two sparse rings that read light of the pilot's first levels. What looks alike in the pilot is on average darker than its
/// surroundings where noise is skewed; so the fit gets as much light, over 25x25 pixels, as the pilot has, which conserves light. For
/// files, where nobody waits: it costs several times the pilot. Wants what ConservingAtrous wants.
/// @tparam Edge an EdgeWeight for geometry; normals may differ, since they are regressors
/// @tparam n    the signal's components
template <class Edge = Product<DepthEdge, NormalEdge>, int n = 3> struct LocalRegression {
    static_assert(EdgeWeight<Edge>, "LocalRegression{...}: `edge` must have around(px), see quell/filter/filter_kernel.hpp");
    using Fit = detail::RegressionOnGuides<Edge, n>;
    using parts = Parts<ConservingAtrous<>, detail::KeepLight<0, n>, detail::KeepLight<1, n>, detail::KeepLight<2, n>, Fit>;
    ConservingAtrous<> pilot{};
    Edge edge = detail::loose_edge<Edge>();
    float width = 25.f;        ///< of the window, in pixels, where the noise is as large as the light; its taps weigh 1/e there
    float least_width = 4.f;   ///< in pixels
    float most_width = 24.f;   ///< in pixels
    float tolerance = 0.0125f; ///< part of the sum of both pixels' luminance that the pilot may differ by at weight 1/e, beside
    float sigma_light = 1.f;   ///< deviations of the pilot, and
    float sigma_noise = 0.2f;  ///< deviations of the accumulated light

    constexpr void for_each_pass(auto&& pass) const {
        int done = 0;
        pilot.for_each_pass([&](auto const& kernel) {
            pass(kernel);
            if (done == 0) pass(detail::KeepLight<0, n>{});
            if (done == 1) pass(detail::KeepLight<1, n>{});
            if (done == 2) pass(detail::KeepLight<2, n>{});
            ++done;
        });
        pass(Fit{edge, width, least_width, most_width, tolerance, sigma_light, sigma_noise});
        for (int const step : {1, 5}) {
            pass(detail::LightLine{step, false});
            pass(detail::LightLine{step, true});
        }
        pass(detail::RestoreLight{});
    }
};

} // namespace quell
