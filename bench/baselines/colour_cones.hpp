#pragma once

#include <quell/filter/atrous.hpp>
#include <quell/frame/modulation.hpp>
#include <quell/radiance/cones.hpp>

/// @file
/// Cones in every pass, as in the paper: `Cones{}, Temporal{motion, blend, ConeFetch{}}, Spatial{ConeAtrous{}}`. They have 24 numbers in a
/// pixel, those of WithCones 12.
///
///     pass          reads                                      writes
///     ingest        sample, indirect_direction, normal         signal: the sample in one of 6 cones      (Cones::inward)
///     Temporal      signal; history, normal then and now       signal; history, moved to this normal     (ConeFetch)
///     ConeAtrous    signal, normal                             signal: cones of 5x5 pixels, per level
///     last pass     signal                                     output: a colour                          (Cones::outward)
namespace quell::inline QUELL_INSTRUCTION_SET {

/// Incident radiance in six cones. Component 4 k + c is the sum of cone k's samples in colour c; component 4 k + 3 is their number. Sums
/// can be filtered linearly; the radiance of a cone is their quotient, taken at the end. Axes are in world space (cone::Axes).
struct ConeRadiance : InternalChannel<24> {
    static constexpr auto name = "cone_radiance";
};
inline constexpr ConeRadiance cone_radiance;

/// A modulation: the pipeline denoises incident radiance in cones instead of a colour. For a signal that is one cosine-distributed sample
/// of incident radiance per pixel, such as Indirect. The output is the mean incident radiance weighted by the cosine; times the albedo it
/// is reflected radiance.
///
///     Pipeline{indirect, Cones{}, Temporal{FirstValid{SurfaceMotion{}, DualMotion{}}, RunningMean{}, ConeFetch{}}, Spatial{ConeAtrous{}}}
struct Cones {
    /// @cond
    using reads = Channels<Normal, IndirectDirection>;
    static constexpr int farthest_tap = 0;
    template <ChannelTag S> using Signal = ConeRadiance;
    /// @endcond

    /// Puts the sample into the nearest cone.
    QUELL_KERNEL auto inward(auto const& px, auto const& sample) const { return cone::deposit(sample, px[indirect_direction], px[normal]); }
    /// Shades the cones to a colour.
    QUELL_KERNEL auto outward(auto const&, auto const& value) const { return cone::shade(value); }
};

static_assert(Modulation<Cones>);

namespace detail {
/// One level of ConeAtrous. Cones pass one to one where normals agree, else by the overlap of all pairs.
template <class Edge> struct ConeLevel {
    static constexpr auto name = "cone a-trous";
    using parts = Parts<Edge>;
    using reads = Channels<Normal>;
    Edge edge;
    int step = 1;
    float min_cosine = 0.f;

    constexpr int farthest_tap() const { return 2 * step; }

    QUELL_KERNEL auto filter(auto px) const {
        using Px = decltype(px);
        using Real = typename Px::Real;
        constexpr int taps = 25;
        constexpr auto& half = CubicSpline::weights;
        constexpr float spline[] = {half[2], half[1], half[0], half[1], half[2]};
        auto const around = edge.around(px);
        auto const n = px[normal];
        Real same[taps], other[taps];
        Coordinate<Real> column[taps], row[taps];
        bool turned = false;
        Real sum_of_weights(0.f);
        for (int t = 0; t < taps; ++t) {
            int const dx = (t % 5 - 2) * step, dy = (t / 5 - 2) * step;
            auto const neighbour = px.at(dx, dy);
            column[t] = neighbour.x, row[t] = neighbour.y;
            float const start = spline[t % 5] * spline[t / 5];
            auto w = Real(start);
            if (t != taps / 2) {
                auto const& toward = edge_toward(around, dx, dy);
                w = start * edge_weight(toward.distance(neighbour, Real(edge_offset(around))));
                w = masked(both(neighbour.inside(), invert(neighbour.missing())), w);
            }
            auto const there = neighbour[normal];
            auto const agree = cone::same_axes(n, there);
            same[t] = masked(agree, w);
            // Small weights are 0 in every lane: the result must not depend on the other pixels of the pack.
            other[t] = select(either(agree, dot(n, there) < Real(min_cosine), w < Real(1e-4f)), Real(0.f), w);
            turned = turned || any(other[t] > Real(0.f));
            sum_of_weights = sum_of_weights + same[t];
        }
        // Surfaces with another normal have the same weights, but their radiance has to change cones.
        Components<24, Real> value{};
        [&]<int... k>(std::integer_sequence<int, k...>) QUELL_INLINED { (add_cone<k>(px, column, row, same, value), ...); }
        (std::make_integer_sequence<int, cone::count>{});
        if (turned) add_turned(px, n, other, value, sum_of_weights);
        auto const inverse = 1.f / max(sum_of_weights, Real(1e-30f));
        auto const result = scale(value, inverse);
        return select(both(all_finite(result), sum_of_weights > Real(0.f)), result, px.signal());
    }

private:
    /// One cone at a time: its sums stay in registers.
    template <int k, class Px, class Real>
    QUELL_KERNEL static void add_cone(Px const& px, Coordinate<Real> const (&column)[25], Coordinate<Real> const (&row)[25],
                                      Real const (&weights)[25], Components<24, Real>& value) {
        Real red(0.f), green(0.f), blue(0.f), samples(0.f);
        for (int t = 0; t < 25; ++t) {
            Px const tap{px.scope, column[t], row[t]};
            red = fma(tap.template signal_component<4 * k>(), weights[t], red);
            green = fma(tap.template signal_component<4 * k + 1>(), weights[t], green);
            blue = fma(tap.template signal_component<4 * k + 2>(), weights[t], blue);
            samples = fma(tap.template signal_component<4 * k + 3>(), weights[t], samples);
        }
        value.at[4 * k] = red, value.at[4 * k + 1] = green, value.at[4 * k + 2] = blue, value.at[4 * k + 3] = samples;
    }
    template <class Px, class Real>
    QUELL_OUTLINED constexpr void add_turned(Px const& px, vec3<Real> const& n, Real const (&weights)[25], Components<24, Real>& value,
                                             Real& sum_of_weights) const {
        for (int t = 0; t < 25; ++t) {
            auto const counts = weights[t] > Real(0.f);
            if (!any(counts)) continue;
            auto const neighbour = px.at((t % 5 - 2) * step, (t / 5 - 2) * step);
            auto const there = neighbour.signal();
            value = select(counts, add_scaled(value, cone::transferred(there, neighbour[normal], n), weights[t]), value);
            sum_of_weights = sum_of_weights + weights[t];
        }
    }
};
} // namespace detail

/// The a-trous wavelet over the six cones of Cones: `levels` passes of a 5x5 B3 spline, whose taps are 1, 2, 4, ... pixels apart (TRMV
/// section 5). Surfaces with another normal contribute where their cones overlap this pixel's.
/// @tparam Edge an EdgeWeight that keeps places apart; normals are dealt with by the cones
template <class Edge = DepthEdge> struct ConeAtrous {
    static_assert(EdgeWeight<Edge>, "ConeAtrous{edge}: `edge` must have around(px), see quell/filter/filter_kernel.hpp");
    /// @cond
    using Level = detail::ConeLevel<Edge>;
    using parts = Parts<Level>;
    /// @endcond
    Edge edge{};            ///< which places count
    int levels = 4;         ///< passes
    float min_cosine = 0.f; ///< surfaces whose normals have a smaller cosine between them do not count

    /// One pass per level.
    constexpr void for_each_pass(auto&& pass) const {
        for (int i = 0; i < levels; ++i) pass(Level{edge, 1 << i, min_cosine});
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
