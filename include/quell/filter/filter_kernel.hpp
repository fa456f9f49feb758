#pragma once

#include <quell/frame/cursor/probe.hpp>
#include <quell/frame/cursor/taps.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// A filter of one pass. It makes the signal anew from a pixel's neighbourhood:
///
///     auto filter(auto px) const                      // the new value, or Result{value}.with(channel it `emits`, value)...
///
/// A kernel whose `constexpr bool feedback() const` gives true makes the signal that goes into the history (Schied et al. 2017). Without
/// one, that is the signal after Temporal.
template <class F>
concept OnePassFilter = std::is_trivially_copyable_v<F> && requires(F const f, detail::Probe<F> px) {
    { detail::as_result(f.filter(px)).value } -> std::convertible_to<typename detail::Probe<F>::Signal>;
};
/// A kernel that makes channels and leaves the signal alone:
///
///     auto emit_channels(auto px) const               // emitted<Real>(channel it `emits`, value).with(...)...
template <class F>
concept EmittingKernel = std::is_trivially_copyable_v<F> && requires(F const f, detail::Probe<F> px) {
    {f.emit_channels(px).more};
};
/// What Spatial takes: a OnePassFilter, an EmittingKernel, or a filter of several passes, which has
///
///     void for_each_pass(auto&& pass) const           // calls pass(kernel) for each kernel, in order
///
/// One whose passes all leave the signal alone says `static constexpr bool leaves_signal = true`.
template <class F>
concept FilterKernel = std::is_trivially_copyable_v<F> &&(OnePassFilter<F> || EmittingKernel<F> || detail::HasPasses<F>);

namespace detail {
/// What an edge weight prepares for a tap: toward(dx, dy) where there is one, else itself.
template <class Around> QUELL_KERNEL decltype(auto) edge_toward(Around const& around, int dx, int dy) {
    if constexpr (requires { around.toward(dx, dy); })
        return around.toward(dx, dy);
    else {
        static_assert(!NamesToward<Around>,
                      "`toward` of what around(px) of an edge weight returns must be a function toward(int dx, int dy) const; "
                      "any other member needs another name");
        return (around);
    }
}
/// What a sum of distances starts with.
template <class Around> QUELL_KERNEL float edge_offset(Around const& around) {
    if constexpr (requires {
                      { around.offset() } -> std::convertible_to<float>;
                  })
        return around.offset();
    else {
        static_assert(!NamesOffset<Around>,
                      "`offset` of what around(px) of an edge weight returns must be a function float offset() const; "
                      "any other member needs another name");
        return 0.f;
    }
}
} // namespace detail

/// The weight of a neighbour in a filter is exp(-distance). `around(px)` prepares what depends on the centre alone. Its result has
///
///     Real distance(auto tap, Real sum) const         // sum + the neighbour's distance
///
/// and may have
///
///     auto toward(int dx, int dy) const               // prepares what depends on the tap's offset but not its sign; then has distance()
///     float offset() const                            // where the sum starts, so that distances may be negative and the total is not
///
/// A filter adds the distances of all its edges and takes one exponential (edge_weight).
template <class W>
concept EdgeWeight = std::is_trivially_copyable_v<W> && requires(W const w, detail::Probe<W> px) {
    { detail::edge_toward(w.around(px), 1, 1).distance(px, 0.f) } -> std::convertible_to<float>;
};

namespace detail {
/// The edge weight among a filter's initialisers, or the filter's default. For deduction guides, which clang 14 needs for aggregates; they
/// must not take a radius for an edge.
template <class Default, class... Fields> struct EdgeAmong { using type = Default; };
template <class Default, class First, class... Rest> struct EdgeAmong<Default, First, Rest...> {
    using type = std::conditional_t<std::is_arithmetic_v<First>, typename EdgeAmong<Default, Rest...>::type, First>;
};
} // namespace detail

/// The bits of a weight as a number, as edge_weight takes them.
QUELL_KERNEL float weight_bits(float weight) { return static_cast<float>(std::bit_cast<std::int32_t>(weight)); }
template <class Real> QUELL_KERNEL Real edge_weight(Real distance, float bits_of_weight);

/// exp(-distance), at most 6.2 % too large, in four operations (Schraudolph 1999). It is monotonic, and exactly 1 at 0. The minimum is
/// 2^-62, also for NaN, so that its square is no denormal.
template <class Real> QUELL_KERNEL Real edge_weight(Real distance) { return edge_weight(distance, weight_bits(1.f)); }

/// weight * exp(-distance) at the same cost.
/// @param distance       sum of distances, at least 0
/// @param bits_of_weight weight_bits(weight)
template <class Real> QUELL_KERNEL Real edge_weight(Real distance, float bits_of_weight) {
    constexpr float per_unit = 12102203.16f, min_bits = 545259520.f; // 2^23 / ln 2, and the bits of 2^-62
    return from_bits(truncate(max(fma(distance, Real(-per_unit), Real(bits_of_weight)), Real(min_bits))));
}

namespace detail {
/// Calls visit(neighbour, distance, bits) for the (2 radius + 1)^2 taps without the centre, `step` pixels apart. edge_weight(distance,
/// bits) is the tap's edge weight times the weight whose bits are bits_of(|column|, |row|).
/// @tparam skips_missing missing samples, where they are still marked, get weight 0
template <bool skips_missing, int radius = 2, class Px, class Around, class Bits, class Visit>
QUELL_KERNEL void for_each_edge_distance(Px const& px, int step, Around const& around, Bits&& bits_of, Visit&& visit) {
    static_assert(
        requires(typename Px::Real sum) { sum = edge_toward(around, 1, 1).distance(px, sum); },
        "distance(near, sum) of an edge weight must take and return the cursor's Real: `typename decltype(px)::Real`");
    auto const usable = [](auto const& neighbour, auto start) QUELL_INLINED {
        if constexpr (skips_missing && Px::Scope::marks_missing)
            return select(neighbour.missing(), decltype(start)(too_far), start);
        else
            return start;
    };
    // Both distances first: two independent chains of operations.
    for_each_opposite_taps<radius>(px, step, edge_offset(around),
                                   [&](auto const& neighbour, auto start, float row, auto const& opposite, auto its_start, float its_row,
                                       int dx, int dy, int i, int j) QUELL_INLINED {
                                       auto const& toward = edge_toward(around, dx, dy);
                                       float const weight = bits_of(i < 0 ? -i : i, j);
                                       auto const distance = toward.distance(neighbour, usable(neighbour, start));
                                       auto const its_distance = toward.distance(opposite, usable(opposite, its_start));
                                       visit(neighbour, distance, weight + row);
                                       visit(opposite, its_distance, weight + its_row);
                                   });
}
/// The same with the weight: add(neighbour, w).
template <bool skips_missing, int radius = 2, class Px, class Around, class Bits, class Add>
QUELL_KERNEL void for_each_edge_tap(Px const& px, int step, Around const& around, Bits&& bits_of, Add&& add) {
    for_each_edge_distance<skips_missing, radius>(px, step, around, bits_of,
                                                  [&](auto const& neighbour, auto distance, float bits)
                                                      QUELL_INLINED { add(neighbour, edge_weight(distance, bits)); });
}
} // namespace detail

} // namespace quell::inline QUELL_INSTRUCTION_SET
