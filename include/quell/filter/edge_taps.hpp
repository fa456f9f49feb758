#pragma once

#include <quell/core/recording.hpp>
#include <quell/filter/filter_kernel.hpp>

#include <bit>
#include <cstddef>
#include <cstdint>

/// The taps of a filter by edge weights: one exponential each, and no test at the image's border.
namespace quell::inline QUELL_INSTRUCTION_SET {

/// A weight that is known beforehand, as edge_weight takes it: the bits of the float, as a number. They are the weight's logarithm, nearly:
/// a sum of them is a product of weights.
struct WeightBits {
    float number; ///< the bits

    /// Those of a weight above 0.
    QUELL_KERNEL static WeightBits of(float weight) { return {static_cast<float>(std::bit_cast<std::int32_t>(weight))}; }
};

/// weight * exp(-distance), at most 6.2 % too large, in four operations (Schraudolph 1999). It is monotonic, and exactly the weight at 0.
/// The minimum is 2^-62, also for NaN, so that its square is no denormal.
/// @param distance sum of distances, at least 0
/// @param weight   what to multiply by
template <class Real> QUELL_KERNEL Real edge_weight(Real distance, WeightBits weight = WeightBits::of(1.f)) {
    constexpr float per_unit = 12102203.16f, min_bits = 545259520.f; // 2^23 / ln 2, and the bits of 2^-62
    return from_bits(truncate(max(fma(distance, Real(-per_unit), Real(weight.number)), Real(min_bits))));
}

/// A distance of taps outside the image, which gives them the smallest edge_weight there is.
inline constexpr float too_far = 1e9f;

/// What for_each_edge_tap() hands over.
template <class Px> struct EdgeTap {
    using Real = typename Px::Real; ///< float or a pack

    Px px;              ///< the cursor at the tap
    Real distance;      ///< sum of the edges' distances; too_far in columns outside the image
    int column, row;    ///< where it lies, in taps from the centre
    float outside_bits; ///< added to a weight's bits: 0, and so little in rows outside the image that the smallest weight comes of it

    /// The weight of its edges times one that is known beforehand.
    QUELL_KERNEL Real weight(WeightBits known) const { return weight(known, distance); }
    /// The same with another distance: this tap's and something more.
    QUELL_KERNEL Real weight(WeightBits known, Real sum) const { return edge_weight(sum, WeightBits{known.number + outside_bits}); }
};

namespace detail {
/// Where a tap's sum of distances starts.
template <bool skips_missing, class Px> QUELL_KERNEL auto start_at(Px const& tap, typename Px::Real start) {
    if constexpr (skips_missing && Px::Scope::marks_missing)
        return select(tap.missing(), typename Px::Real(too_far), start);
    else
        return start;
}
} // namespace detail

/// Calls body(tap) with an EdgeTap for each of the (2 radius + 1)^2 taps without the centre, `step` pixels apart. Opposite taps follow each
/// other: what depends on their distance only is computed once for two.
/// @tparam skips_missing missing samples, where they are still marked, get the smallest weight
/// @tparam radius        in taps; it is unrolled: use small ones
/// @param px             the centre, a cursor
/// @param step           from a tap to the next, in pixels
/// @param around         what around(px) of an EdgeWeight returns
/// @param body           body(tap)
template <bool skips_missing, int radius, class Px, class Around, class Body>
    requires(!records<typename Px::Real>)
QUELL_KERNEL void for_each_edge_tap(Px const& px, int step, Around const& around, Body&& body) {
    using Real = typename Px::Real;
    static_assert(
        requires(Real sum) { sum = detail::edge_toward(around, 1, 1).distance(px, sum); },
        "distance(near, sum) of an edge weight must take and return the cursor's Real: `typename decltype(px)::Real`");
    static_assert(Px::pack_width == width_of<Real>, "a pass of `two_rows` takes taps by for_each_tap");
    constexpr int side = 2 * radius + 1;
    constexpr float too_little = -1e10f; // weight bits
    float const base = detail::edge_offset(around);
    Real start[std::size_t{side}];
    int column[std::size_t{side}];
    QUELL_UNROLL
    for (int i = 0; i < side; ++i) {
        auto const beside = px.at((i - radius) * step, 0);
        start[i] = select(beside.inside(), Real(base), Real(too_far));
        column[i] = beside.x;
    }
    QUELL_UNROLL
    for (int j = 0; j <= radius; ++j) {
        auto const below = px.at(0, j * step), above = px.at(0, -j * step);
        float const below_bits = below.row_inside ? 0.f : too_little, above_bits = above.row_inside ? 0.f : too_little;
        QUELL_UNROLL
        for (int i = j == 0 ? 1 : -radius; i <= radius; ++i) {
            auto const& toward = detail::edge_toward(around, i * step, j * step);
            Px const one{px.scope, column[radius + i], below.y}, opposite{px.scope, column[radius - i], above.y};
            // Both distances first: two independent chains of operations.
            auto const distance = toward.distance(one, detail::start_at<skips_missing>(one, start[radius + i]));
            auto const its_distance = toward.distance(opposite, detail::start_at<skips_missing>(opposite, start[radius - i]));
            body(EdgeTap<Px>{one, distance, i, j, below_bits});
            body(EdgeTap<Px>{opposite, its_distance, -i, -j, above_bits});
        }
    }
}

} // namespace quell::inline QUELL_INSTRUCTION_SET
