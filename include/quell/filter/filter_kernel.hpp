#pragma once

#include <quell/frame/cursor/probe.hpp>
#include <quell/frame/cursor/taps.hpp>

namespace quell {

namespace detail {
/// Accepts any pass. A struct, since nvcc takes no lambda inside a concept.
struct AnyPass {
    constexpr void operator()(auto const&) const {}
};
} // namespace detail

/// Replaces a pixel by something made of its surroundings. A filter that is one pass has
///     auto filter(auto px) const -> the new value, or Result{value}.with(channel that it `emits`, value)...
/// A filter of several passes has
///     void for_each_pass(auto&& pass) const       which calls pass(kernel) in order, each kernel being a one-pass filter
/// A kernel that leaves the signal alone and only makes other channels has `emit_channels(px)` instead of filter, which returns
/// emitted<Real>(channel, value), and says
///     static constexpr bool leaves_signal = true
/// One marked `feedback` makes the signal that history remembers (SVGF); without such a mark that is what the last Temporal stage made.
template <class F>
concept OnePassFilter = std::is_trivially_copyable_v<F> && requires(F const f, detail::Probe<F> px) {
    { detail::as_result(f.filter(px)).value } -> std::convertible_to<typename detail::Probe<F>::Signal>;
};
template <class F>
concept EmittingKernel = std::is_trivially_copyable_v<F> && requires(F const f, detail::Probe<F> px) {
    {f.emit_channels(px).more};
};
template <class F>
concept FilterKernel = std::is_trivially_copyable_v<F> &&
    (OnePassFilter<F> || EmittingKernel<F> || requires(F const f) { f.for_each_pass(detail::AnyPass{}); });

namespace detail {
/// What an edge weight prepares for a tap's place: itself, unless it has something that depends on the place.
template <class Around> QUELL_KERNEL decltype(auto) edge_toward(Around const& around, int dx, int dy) {
    if constexpr (requires { around.toward(dx, dy); })
        return around.toward(dx, dy);
    else
        return (around);
}
/// What is added to every tap's distance.
template <class Around> QUELL_KERNEL float edge_offset(Around const& around) {
    if constexpr (requires { around.offset(); })
        return around.offset();
    else
        return 0.f;
}
} // namespace detail

/// Says how much a neighbour may contribute: exp(-distance). `around(px)` prepares what depends on the centre alone; that has
///     Real distance(auto tap, Real sum) const         sum + the neighbour's distance
/// and may have
///     auto toward(int dx, int dy) const               prepares what depends on the tap's place, up to its sign; then this has distance()
///     float offset() const                            is added to each distance, which is at least 0 with it: for a sum that starts there
/// A filter adds up the distances of all its edges, and takes the exponential once (edge_weight).
template <class W>
concept EdgeWeight = std::is_trivially_copyable_v<W> && requires(W const w, detail::Probe<W> px) {
    { detail::edge_toward(w.around(px), 1, 1).distance(px, 0.f) } -> std::convertible_to<float>;
};

namespace detail {
/// The edge weight among the fields that a filter is initialised with, or the filter's default: for deduction guides, which clang 14 needs
/// for aggregates and which must not take a radius for an edge.
template <class Default, class... Fields> struct EdgeAmong { using type = Default; };
template <class Default, class First, class... Rest> struct EdgeAmong<Default, First, Rest...> {
    using type = std::conditional_t<std::is_arithmetic_v<First>, typename EdgeAmong<Default, Rest...>::type, First>;
};
} // namespace detail

/// What edge_weight wants to know of a weight.
QUELL_KERNEL float weight_bits(float weight) { return static_cast<float>(std::bit_cast<std::int32_t>(weight)); }
template <class Real> QUELL_KERNEL Real edge_weight(Real distance, float bits_of_weight);

/// exp(-distance) in four operations: the float whose bits are a linear function of the exponent (Schraudolph 1999). Exactly 1 at 0, on the
/// chords between powers of two elsewhere, so at most 6.2 % above the exponential and monotonic. Never under 2^-62, so that its square is
/// no denormal; a NaN gives that too.
template <class Real> QUELL_KERNEL Real edge_weight(Real distance) { return edge_weight(distance, weight_bits(1.f)); }

/// weight * exp(-distance) for the price of exp(-distance): the bits of `weight` take the place of the bits of 1.
template <class Real> QUELL_KERNEL Real edge_weight(Real distance, float bits_of_weight) {
    constexpr float per_unit = 12102203.16f, least = 545259520.f; // 2^23 / ln 2, and the bits of 2^-62
    return from_bits(truncate(max(fma(distance, Real(-per_unit), Real(bits_of_weight)), Real(least))));
}

namespace detail {
/// Calls visit(near, distance, bits) for the neighbours in a (2 radius + 1)^2 whose taps stand `step` pixels apart: edge_weight(distance,
/// bits) is the tap's edge weight times the weight whose bits (weight_bits) are bits_of(|column|, |row|).
/// @tparam skips_missing missing samples, where they are still marked, weigh nothing
template <bool skips_missing, int radius = 2, class Px, class Around, class Bits, class Visit>
QUELL_KERNEL void for_each_edge_distance(Px const& px, int step, Around const& around, Bits&& bits_of, Visit&& visit) {
    auto const usable = [](auto const& neighbour, auto start) QUELL_INLINED {
        if constexpr (skips_missing && Px::Scope::marks_missing)
            return select(neighbour.missing(), decltype(start)(too_far), start);
        else
            return start;
    };
    // Both distances come first, so that two chains of dependent operations are under way at a time.
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
/// The same with the weight itself: add(near, w).
template <bool skips_missing, int radius = 2, class Px, class Around, class Bits, class Add>
QUELL_KERNEL void for_each_edge_tap(Px const& px, int step, Around const& around, Bits&& bits_of, Add&& add) {
    for_each_edge_distance<skips_missing, radius>(px, step, around, bits_of,
                                                  [&](auto const& neighbour, auto distance, float bits)
                                                      QUELL_INLINED { add(neighbour, edge_weight(distance, bits)); });
}
} // namespace detail

} // namespace quell
