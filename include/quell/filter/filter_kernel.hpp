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
/// A filter adds the distances of all its edges and takes one exponential (edge_weight, for_each_edge_tap).
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

} // namespace quell::inline QUELL_INSTRUCTION_SET
