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

/// The largest difference of any component. Alpha, which a fourth one is, has no unit: its difference counts as that of so much light.
template <class V> QUELL_KERNEL auto largest_difference(V const& a, V const& b, [[maybe_unused]] real_of<V> light) {
    constexpr int of_light = components_of<V> == 4 ? 3 : components_of<V>;
    auto maximum = abs(component<0>(a) - component<0>(b));
    repeat<of_light>([&](auto c) QUELL_INLINED { maximum = max(maximum, abs(component<c>(a) - component<c>(b))); });
    if constexpr (components_of<V> == 4) maximum = max(maximum, abs(component<3>(a) - component<3>(b)) * light);
    return maximum;
}

/// The fit of LocalRegression.
template <class Edge, int n> struct RegressionOnGuides {
    static constexpr auto name = "local regression";
    static constexpr int farthest_tap = 24;
    template <int level> using Light = LessFilteredLight<level, n>;
    using parts = Parts<Edge>;
    using reads = Channels<Normal, HistoryLength, Variance, UnfilteredVariance, Light<0>, Light<2>, Light<3>>;
    using emits = Channels<LightOfPilotAndFit, FreedomOfFit>;
    Edge edge;
    float width, min_width, max_width, tolerance, sigma_light, sigma_noise;

    QUELL_KERNEL auto filter(auto px) const {
        using Px = decltype(px);
        using Real = typename Px::Real;
        auto const pilot = px.signal();
        auto const noise = deviation_around(px);
        auto const light = luminance(pilot), tolerated = light * (2.f * tolerance), expected = noise * sigma_noise;
        Centre<Px, decltype(edge.around(px))> const centre{
            px,
            edge.around(px),
            pilot,
            px[normal],
            fma(tolerated, tolerated, fma(expected, expected, fma(px[variance], Real(sigma_light * sigma_light), Real(1e-36f)))),
            inverse_square_width(noise, light),
            abs(light)};
        Window<typename Px::Signal> window{{}, Hull<typename Px::Signal>(pilot)};
        add_square<0, 2, 1>(centre, window, 1.f);
        add_square<2, 1, 5>(centre, window, 20.f);
        add_square<3, 2, 12>(centre, window, 80.f);
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
        Real allowed_squared, per_square, light;
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
            auto const size = max(abs(a), Real(1e-30f)), farther = select(a < Real(0.f), -low, high),
                       nearer = select(a < Real(0.f), -high, low);
            return min(farther / size, size / max(nearer, Real(1e-30f)));
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
        auto const relative = clamp(noise / max(light, Real(1e-30f)), Real(1e-6f), Real(1e6f));
        // Cube root to a few percent: a third of the exponent.
        auto const root = from_bits(truncate(fma(to_real(bits(relative)), Real(1.f / 3.f), Real(709921077.f))));
        auto const w = clamp(root * width, Real(min_width), Real(max_width));
        return 1.f / (w * w);
    }
    /// Adds (2 radius + 1)^2 taps, `stride` pixels apart. Only where they are all pixels, one is at the centre.
    /// @tparam level  how often the light was filtered: over about as many pixels as lie between two taps
    /// @param  weight of a tap that is like the centre, and one frame
    template <int level, int radius, int stride, class C, class W>
    QUELL_KERNEL void add_square(C const& centre, W& window, float weight) const {
        using Real = typename C::Real;
        constexpr int side = 2 * radius + 1;
        Real weights[std::size_t{side * side}];
        auto const known = WeightBits::of(weight);
        weights[side * side / 2] =
            stride > 1 ? Real(0.f)
                       : edge_weight(edge_toward(centre.around, 0, 0).distance(centre.px, Real(edge_offset(centre.around))), known) *
                             frames(centre.px);
        for_each_edge_tap<true, radius>(centre.px, stride, centre.around, [&](auto const& tap) QUELL_INLINED {
            auto const away = static_cast<float>(stride * stride * (tap.column * tap.column + tap.row * tap.row));
            auto const by_place = fma(centre.per_square, Real(away), tap.distance);
            // The pilot is compared, not the samples that are weighed: weights that depend on them bias the fit.
            auto const inverse = approximate_inverse_sqrt(fma(tap.px[variance], Real(sigma_light * sigma_light), centre.allowed_squared));
            auto const distance = fma(largest_difference(tap.px.signal(), centre.pilot, centre.light), inverse, by_place);
            weights[(radius + tap.row) * side + radius + tap.column] = tap.weight(known, distance) * frames(tap.px);
        });
        auto seen = window.seen;
        QUELL_UNROLL_ON_DEVICE
        for (int j = 0; j < side; ++j) {
            typename decltype(window.fit)::OfRow row;
            int const dy = (j - radius) * stride;
            // One loop for each kind of sums: all at once would not fit into registers.
            QUELL_UNROLL_ON_DEVICE
            for (int i = 0; i < side; ++i) {
                auto const tap = centre.px.at((i - radius) * stride, dy);
                row.add_regressors(place<Real>((i - radius) * stride), turned(centre, tap), weights[j * side + i]);
            }
            QUELL_UNROLL_ON_DEVICE
            for (int i = 0; i < side; ++i) {
                auto const tap = centre.px.at((i - radius) * stride, dy);
                auto const light = tap[Light<level>{}];
                auto const w = weights[j * side + i];
                row.add_value(place<Real>((i - radius) * stride), turned(centre, tap), light, w);
                // Less is of another surface, or outside the image.
                seen.add(light, w > Real(1e-9f));
            }
            window.fit.add(row, place<Real>(dy));
        }
        window.seen = seen;
    }
    template <class Real> QUELL_KERNEL static Real place(int pixels) { return Real(static_cast<float>(pixels) * (1.f / 12.f)); }
    /// How the normal differs from the centre's.
    template <class C, class Px> QUELL_KERNEL static auto turned(C const& centre, Px const& tap) {
        auto const there = tap[normal];
        return vec3<typename C::Real>{there.x - centre.n_here.x, there.y - centre.n_here.y, there.z - centre.n_here.z};
    }
    /// How many frames a pixel's light is the mean of.
    template <class Px> QUELL_KERNEL static auto frames(Px const& px) { return min(px[history_length], typename Px::Real(1e4f)); }
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
/// A ConservingAtrous runs first; its result is the pilot. Taps weigh by geometry, by their difference in the pilot, and by how many
/// frames they are the mean of. The window is 49x49 pixels at most, with 57 taps: all of 5x5 pixels, then 3x3 taps 5 pixels apart and 5x5
/// taps 12 pixels apart, which read the light after two and after three levels of the pilot, as wide as they are far apart. Its width
/// follows the noise. Finally the fit is scaled to the pilot's luminance over 25x25 pixels, so that no light is lost: with skewed noise,
/// pixels that look alike are darker than their surroundings.
///
/// It costs a few times the pilot. Like ConservingAtrous it goes after a Temporal{motion, WithVariance{...}} whose policy keeps the
/// history length.
/// @tparam Edge an EdgeWeight for geometry; keep it loose on normals, which are regressors
/// @tparam n    the signal's components
template <class Edge = Product<DepthEdge, NormalEdge>, int n = 3> struct LocalRegression {
    static_assert(EdgeWeight<Edge>, "LocalRegression{...}: `edge` must have around(px), see quell/filter/filter_kernel.hpp");
    /// @cond
    using Fit = detail::RegressionOnGuides<Edge, n>;
    using parts = Parts<ConservingAtrous<>, detail::KeepLight<0, n>, detail::KeepLight<2, n>, detail::KeepLight<3, n>, Fit>;
    /// @endcond
    ConservingAtrous<> pilot{};             ///< runs first
    Edge edge = detail::loose_edge<Edge>(); ///< which neighbours belong to the same surface
    float width = 25.f;                     ///< distance in pixels at which taps have weight 1/e where the noise is as large as the light
    float min_width = 4.f;                  ///< minimum of that distance
    float max_width = 24.f;                 ///< maximum of that distance
    float tolerance =
        0.03f; ///< difference in the pilot with weight 1/e, the root of a sum of squares: of this part of twice the luminance,
    float sigma_light = 1.3f;  ///< of this many standard deviations of the pilot's noise, whose variances in both pixels are added,
    float sigma_noise = 0.26f; ///< and of this many of the accumulated light's noise

    /// The pilot's passes, the fit, and the scaling to the pilot's luminance.
    constexpr void for_each_pass(auto&& pass) const {
        int done = 0;
        auto const keep_light = [&] {
            if (done == 0) pass(detail::KeepLight<0, n>{});
            if (done == 2) pass(detail::KeepLight<2, n>{});
            if (done == 3) pass(detail::KeepLight<3, n>{});
            ++done;
        };
        pilot.for_each_pass([&](auto const& kernel) { pass(kernel), keep_light(); });
        while (done <= 3) keep_light();
        pass(Fit{edge, width, min_width, max_width, tolerance, sigma_light, sigma_noise});
        for (int const step : {1, 5}) {
            pass(detail::LightLine{step, false});
            pass(detail::LightLine{step, true});
        }
        pass(detail::RestoreLight{});
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
