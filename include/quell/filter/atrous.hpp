#pragma once

#include <quell/filter/edge_weights.hpp>
#include <quell/filter/wavelet_taps.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {
/// The centre where v is not finite. A NaN in a guide can get this far where compiler flags assume that there are none.
template <class V> QUELL_KERNEL V finite_or(V const& v, V const& centre) { return select(all_finite(v), v, centre); }

/// One level of the wavelet. With `guided` it also filters the variance, by squared weights.
/// @tparam Taps SplineTaps or NearestTaps
template <class Edge, bool guided, class Taps> struct AtrousLevel {
    static constexpr auto name = guided ? "variance-guided a-trous" : "a-trous";
    using parts = Parts<Edge>;
    using reads = std::conditional_t<guided, Channels<Variance>, Channels<>>;
    using emits = reads;
    Edge edge;
    int step = 1;
    Taps taps{};
    bool into_history = false;

    constexpr int farthest_tap() const { return Taps::radius * step; }

    constexpr bool feedback() const { return into_history; }
    QUELL_KERNEL auto filter(auto px) const {
        using Px = decltype(px);
        using Real = typename Px::Real;
        auto const around = edge.around(px);
        auto sum = scale(px.signal(), Real(taps.centre));
        Real weights(taps.centre), noise(0.f);
        if constexpr (guided) noise = px[variance] * (weights * weights);
        for_each_edge_tap<true, Taps::radius>(px, step, around, [&](auto const& tap) QUELL_INLINED {
            auto const w = tap.weight(taps.at(tap.column, tap.row));
            sum = add_scaled(sum, tap.px.signal(), w);
            weights = weights + w;
            if constexpr (guided) noise = fma(tap.px[variance], w * w, noise);
        });
        auto const inverse = 1.f / weights;
        auto const result = Result{finite_or(scale(sum, inverse), px.signal())};
        if constexpr (guided)
            return result.with(variance, finite_or(noise * (inverse * inverse), px[variance]));
        else
            return result;
    }
};
} // namespace detail

/// The edge-avoiding a-trous wavelet (Dammertz 2010): `levels` passes, whose taps are further and further apart.
///
///     Atrous<>{.levels = 4}
///     Atrous{Product{NormalEdge{}, LuminanceEdge{}}, 4}
///
/// @tparam Edge   an EdgeWeight
/// @tparam Spline the taps: CubicSpline, LinearSpline or LinearThenBox
template <class Edge = Product<DepthEdge, NormalEdge>, class Spline = CubicSpline> struct Atrous {
    static_assert(EdgeWeight<Edge>, "Atrous{edge}: `edge` must have around(px), see quell/filter/filter_kernel.hpp");
    using parts = Parts<Edge>;
    Edge edge{};    ///< which neighbours count
    int levels = 5; ///< passes; 5 of 5x5 taps reach 62 pixels

    /// @cond
    using Level = detail::AtrousLevel<Edge, false, detail::TapsOf<Spline>>;
    /// @endcond
    /// One pass per level.
    constexpr void for_each_pass(auto&& pass) const {
        detail::for_each_level<Spline>(levels, 1, [&](int, int step, auto taps) { pass(Level{edge, step, taps}); });
    }
};
template <class... Fields> Atrous(Fields...) -> Atrous<typename detail::EdgeAmong<Product<DepthEdge, NormalEdge>, Fields...>::type>;

} // namespace quell::inline QUELL_INSTRUCTION_SET
