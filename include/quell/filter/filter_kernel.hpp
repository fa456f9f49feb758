#pragma once

#include <quell/filter/taps.hpp>

namespace quell {

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
concept FilterKernel = std::is_trivially_copyable_v<F> && (OnePassFilter<F> || requires(F const f) { f.for_each_pass([](auto const&) {}); });

/// Says how much a neighbour may contribute. `around(px)` prepares what depends on the centre alone; its
///     Real root(auto near, int dx, int dy) const
/// is the thirty-second root of the weight, in [0, 1]: a filter multiplies the roots of all its edge weights and raises the product once, by five
/// squarings, so that exp(-x) costs one subtraction, as (1 - x / 32)^32.
template <class W>
concept EdgeWeight = std::is_trivially_copyable_v<W> && requires(W const w, detail::Probe<W> px) {
    { w.around(px).root(px, 1, 1) } -> std::convertible_to<float>;
};

namespace detail {
/// The root of exp(-x) for x >= 0; a NaN gives 0.
template <class Real>
QUELL_KERNEL Real root_of_exp(Real x) { return max(1.f - x * (1.f / 32.f), Real(0.f)); }
} // namespace detail

} // namespace quell
