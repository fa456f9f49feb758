#pragma once

#include <quell/filter/taps.hpp>

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
/// A kernel that leaves the signal alone and only makes other channels has `emit(px) -> Result` instead of filter. One marked
/// `feedback` makes the signal that history remembers (SVGF); without such a mark that is what the last Temporal stage made.
template <class F>
concept OnePassFilter = std::is_trivially_copyable_v<F> && requires(F const f, detail::Probe<F> px) {
    { detail::as_result(f.filter(px)).value } -> std::convertible_to<vec3<float>>;
};
template <class F>
concept FilterKernel = std::is_trivially_copyable_v<F> &&(OnePassFilter<F> || requires(F const f) { f.for_each_pass(detail::AnyPass{}); });

/// Says how much a neighbour may contribute: exp(-distance). `around(px)` prepares what depends on the centre alone; `toward(dx, dy)` of
/// that, what depends on the tap's place, up to its sign; and of that
///     Real distance(auto near, Real sum) const
/// adds what the neighbour itself makes of it, at least 0, to a sum of distances. A filter takes the exponential of the sum once
/// (edge_weight).
template <class W>
concept EdgeWeight = std::is_trivially_copyable_v<W> && requires(W const w, detail::Probe<W> px) {
    { w.around(px).toward(1, 1).distance(px, 0.f) } -> std::convertible_to<float>;
};

namespace detail {
/// The edge weight among the fields that a filter is initialised with, or the filter's default: for deduction guides, which clang 14 needs
/// for aggregates and which must not take a radius for an edge.
template <class Default, class... Fields> struct EdgeAmong { using type = Default; };
template <class Default, class First, class... Rest> struct EdgeAmong<Default, First, Rest...> {
    using type = std::conditional_t<std::is_arithmetic_v<First>, typename EdgeAmong<Default, Rest...>::type, First>;
};
} // namespace detail

/// exp(-distance) in four operations: the float whose bits are a linear function of the exponent (Schraudolph 1999). Exactly 1 at 0, on the
/// chords between powers of two elsewhere, so at most 6.2 % above the exponential and monotonic. Never under 2^-62, so that its square is
/// no denormal; a NaN gives that too.
template <class Real> QUELL_KERNEL Real edge_weight(Real distance) {
    constexpr float per_unit = 12102203.16f, one = 1065353216.f, least = 545259520.f; // 2^23 / ln 2, and the bits of 1 and of 2^-62
    return from_bits(truncate(max(fma(distance, Real(-per_unit), Real(one)), Real(least))));
}

} // namespace quell
