#pragma once

#include <quell/filter/edge_weights.hpp>

#include <iterator>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// 5x5 taps of a wavelet: a B3 spline (Dammertz 2010).
struct CubicSpline {
    static constexpr float weights[] = {0.375f, 0.25f, 0.0625f}; ///< along one axis, from the centre outwards
};
/// 3x3 taps of a wavelet: a third of the taps of CubicSpline, and half the reach.
struct LinearSpline {
    static constexpr float weights[] = {0.5f, 0.25f}; ///< along one axis, from the centre outwards
};

namespace detail {
/// The bits of a spline's weights (weight_bits), by |column| and |row|.
template <class Spline> struct SplineBits {
    static constexpr int radius = static_cast<int>(std::size(Spline::weights)) - 1;
    float at[std::size_t{radius + 1}][std::size_t{radius + 1}];
    constexpr SplineBits() : at{} {
        for (int i = 0; i <= radius; ++i)
            for (int j = 0; j <= radius; ++j)
                at[i][j] = static_cast<float>(std::bit_cast<std::int32_t>(Spline::weights[i] * Spline::weights[j]));
    }
};
template <class Spline> inline constexpr SplineBits<Spline> spline_bits;

/// The centre where v is not finite. A NaN in a guide can get this far where compiler flags assume that there are none.
template <class V> QUELL_KERNEL V finite_or(V const& v, V const& centre) { return select(all_finite(v), v, centre); }

/// One level of the wavelet. With `guided` it also filters the variance, by squared weights.
template <class Edge, bool guided, class Spline = CubicSpline> struct AtrousLevel {
    static constexpr auto name = guided ? "variance-guided a-trous" : "a-trous";
    using parts = Parts<Edge>;
    using reads = std::conditional_t<guided, Channels<Variance>, Channels<>>;
    using emits = reads;
    Edge edge;
    int step = 1;
    bool feedback = false;

    QUELL_KERNEL auto filter(auto px) const {
        using Px = decltype(px);
        using Real = typename Px::Real;
        auto const around = edge.around(px);
        constexpr float centre = Spline::weights[0] * Spline::weights[0];
        auto sum = scale(px.signal(), Real(centre));
        Real weights(centre), noise(0.f);
        if constexpr (guided) noise = px[variance] * (weights * weights);
        auto const add = [&](auto const& neighbour, auto w) QUELL_INLINED {
            sum = add_scaled(sum, neighbour.signal(), w);
            weights = weights + w;
            if constexpr (guided) noise = fma(neighbour[variance], w * w, noise);
        };
        for_each_edge_tap<true, SplineBits<Spline>::radius>(
            px, step, around, [](int i, int j) QUELL_INLINED { return spline_bits<Spline>.at[i][j]; }, add);
        auto const inverse = 1.f / weights;
        auto const result = Result{finite_or(scale(sum, inverse), px.signal())};
        if constexpr (guided)
            return result.with(variance, finite_or(noise * (inverse * inverse), px[variance]));
        else
            return result;
    }
};
} // namespace detail

/// The edge-avoiding a-trous wavelet (Dammertz 2010): `levels` passes whose taps are 1, 2, 4, ... pixels apart.
///
///     Atrous<>{.levels = 4}
///     Atrous{Product{NormalEdge{}, LuminanceEdge{}}, 4}
///
/// @tparam Edge   an EdgeWeight
/// @tparam Spline CubicSpline, or LinearSpline for 3x3
template <class Edge = Product<DepthEdge, NormalEdge>, class Spline = CubicSpline> struct Atrous {
    static_assert(EdgeWeight<Edge>, "Atrous{edge}: `edge` must have around(px), see quell/filter/filter_kernel.hpp");
    using parts = Parts<Edge>;
    Edge edge{};    ///< which neighbours count
    int levels = 5; ///< passes; 5 of 5x5 taps reach 62 pixels

    /// @cond
    using Level = detail::AtrousLevel<Edge, false, Spline>;
    /// @endcond
    /// One pass per level.
    constexpr void for_each_pass(auto&& pass) const {
        for (int i = 0; i < levels; ++i) pass(Level{edge, 1 << i});
    }
};
template <class... Fields> Atrous(Fields...) -> Atrous<typename detail::EdgeAmong<Product<DepthEdge, NormalEdge>, Fields...>::type>;

} // namespace quell::inline QUELL_INSTRUCTION_SET
