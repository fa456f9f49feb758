#pragma once

#include <quell/filter/atrous.hpp>
#include <quell/frame/hull.hpp>
#include <quell/radiance/cones.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Shades each pixel by the sum of the cones of the 3x3 around it: their mean colour, as bright as their cones shade to, but no component
/// beyond those of the 3x3. A disoccluded pixel has samples in few of its cones; its neighbours fill the others. Goes after a
/// Temporal{motion, WithCones{...}, ConeFetch{}} and before a filter of colours.
///
///     Spatial{ConeGather{}}, Spatial{VarianceGuidedAtrous{}}
///
/// @tparam Edge an EdgeWeight that keeps different normals apart: cones are added one to one
template <class Edge = Product<DepthEdge, NormalEdge>> struct ConeGather {
    static_assert(EdgeWeight<Edge>, "ConeGather{edge}: `edge` must have around(px), see quell/filter/filter_kernel.hpp");
    static constexpr auto name = "cone gather";
    using parts = Parts<Edge>;
    using reads = Channels<ConeLuminance>;
    static constexpr int farthest_tap = 1;
    Edge edge{}; ///< which neighbours count

    /// The shaded colour; the signal as it is where there are no samples.
    QUELL_KERNEL auto filter(auto px) const {
        using Px = decltype(px);
        using Real = typename Px::Real;
        auto const around = edge.around(px);
        constexpr float profile[] = {0.5f, 0.25f};
        Taps<Px> taps;
        taps.add(px, Real(profile[0] * profile[0]));
        for_each_edge_tap<false, 1>(px, 1, around, [&](auto const& tap) QUELL_INLINED {
            taps.add(tap.px, tap.weight(WeightBits::of(profile[tap.column != 0] * profile[tap.row != 0])));
        });
        auto colour = zero<typename Px::Signal>();
        detail::Hull<typename Px::Signal> seen(px.signal());
        Real weight(0.f);
        QUELL_UNROLL_ON_DEVICE
        for (int t = 0; t < taps.count; ++t) {
            auto const signal = taps.at(px, t).signal();
            taps.light[t] = luminance(signal) * taps.weight[t];
            seen.add(signal, taps.weight[t] > Real(counts_from));
            colour = add_scaled(colour, signal, taps.weight[t]);
            weight = weight + taps.weight[t];
        }
        Components<12, Real> sum;
        detail::repeat<2>([&](auto i) QUELL_INLINED { add_three_cones<3 * i>(px, taps, sum); });
        auto const mean = cone::mean(sum);
        auto const shaded = scale(colour, cone::shade(sum) / (max(mean, Real(1e-30f)) * weight));
        // With no samples in reach there is nothing to shade; without light no ratio.
        return select(both(cone::samples(sum) > Real(1e-6f), mean > Real(0.f), all_finite(shaded)), seen.limited(shaded), px.signal());
    }

private:
    static constexpr float counts_from = 1e-6f; ///< weight: less is of another surface, or outside the image

    template <class Px> struct Taps {
        Coordinate<typename Px::Real> column[9], row[9];
        typename Px::Real weight[9], light[9]; // of a neighbour, and that times its luminance
        int count = 0;
        QUELL_KERNEL void add(Px const& tap, typename Px::Real w) { column[count] = tap.x, row[count] = tap.y, weight[count++] = w; }
        QUELL_KERNEL Px at(Px const& px, int t) const { return {px.scope, column[t], row[t]}; }
    };
    /// Three cones at a time: as many sums as fit in registers.
    template <int k, class Px, class Real>
    QUELL_KERNEL static void add_three_cones(Px const& px, Taps<Px> const& taps, Components<12, Real>& sum) {
        [&]<int... c>(std::integer_sequence<int, c...>) QUELL_INLINED {
            Real sums[] = {((void)c, Real(0.f))...}, numbers[] = {((void)c, Real(0.f))...};
            QUELL_UNROLL_ON_DEVICE
            for (int t = 0; t < 9; ++t) {
                auto const tap = taps.at(px, t);
                auto const add = [&](auto i, Real& its_sum, Real& its_number) QUELL_INLINED {
                    auto const count = tap.template channel_component<i + 1>(cone_luminance);
                    its_sum = fma(tap.template channel_component<i>(cone_luminance), count * taps.light[t], its_sum);
                    its_number = fma(count, taps.weight[t], its_number);
                };
                (add(std::integral_constant<int, 2 * (k + c)>{}, sums[c], numbers[c]), ...);
            }
            ((sum.at[2 * (k + c)] = sums[c], sum.at[2 * (k + c) + 1] = numbers[c]), ...);
        }
        (std::make_integer_sequence<int, 3>{});
    }
};
template <class Edge> ConeGather(Edge) -> ConeGather<Edge>;

} // namespace quell::inline QUELL_INSTRUCTION_SET
