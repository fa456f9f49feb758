#pragma once

#include <quell/filter/edge_weights.hpp>

namespace quell {

namespace detail {
inline constexpr float b3_spline[3] = {0.375f, 0.25f, 0.0625f};

/// What edge_weight wants to know of the spline's weights, by |column| and |row|.
struct SplineBits {
    float at[3][3];
    constexpr SplineBits() : at{} {
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) at[i][j] = static_cast<float>(std::bit_cast<std::int32_t>(b3_spline[i] * b3_spline[j]));
    }
};
inline constexpr SplineBits spline_bits;

/// Gives back the centre where arithmetic went wrong: a NaN in a guide, under flags that let the compiler assume there is none.
template <class V> QUELL_KERNEL V finite_or(V const& v, V const& centre) { return select(all_finite(v), v, centre); }

/// One level of the edge-avoiding wavelet. With `guided` it filters the variance along, by squared weights.
template <class Edge, bool guided> struct AtrousLevel {
    static constexpr auto name = guided ? "variance-guided a-trous" : "a-trous";
    using reads = std::conditional_t<guided, decltype(reads_of<Edge>{} | Channels<Variance>{}), reads_of<Edge>>;
    using emits = std::conditional_t<guided, Channels<Variance>, Channels<>>;
    Edge edge;
    int step = 1;
    bool feedback = false;

    QUELL_KERNEL auto filter(auto px) const {
        using Px = decltype(px);
        using Real = typename Px::Real;
        auto const around = edge.around(px);
        auto sum = scale(px.signal(), Real(b3_spline[0] * b3_spline[0]));
        Real weights(b3_spline[0] * b3_spline[0]), noise(0.f);
        if constexpr (guided) noise = px[variance] * (weights * weights);
        auto const add = [&](auto const& near, auto w) __attribute__((always_inline)) {
            sum = add_scaled(sum, near.signal(), w);
            weights = weights + w;
            if constexpr (guided) noise = fma(near[variance], w * w, noise);
        };
        for_each_edge_tap<true>(
            px, step, around, [](int i, int j) __attribute__((always_inline)) { return spline_bits.at[i][j]; }, add);
        auto const inverse = 1.f / weights;
        auto const result = Result{finite_or(scale(sum, inverse), px.signal())};
        if constexpr (guided)
            return result.with(variance, finite_or(noise * (inverse * inverse), px[variance]));
        else
            return result;
    }
};
} // namespace detail

/// The edge-avoiding a-trous wavelet: `levels` passes of a 5x5 B3 spline whose taps stand 1, 2, 4, ... pixels apart (Dammertz 2010).
///     Atrous<>{.levels = 4}    or    Atrous{Product{NormalEdge{}, LuminanceEdge{}}, 4}
/// @tparam Edge an EdgeWeight
template <class Edge = Product<DepthEdge, NormalEdge>> struct Atrous {
    static_assert(EdgeWeight<Edge>, "Atrous{edge}: `edge` must have around(px), see quell/filter/filter_kernel.hpp");
    using reads = reads_of<Edge>;
    Edge edge{};
    int levels = 5;

    using Level = detail::AtrousLevel<Edge, false>;
    constexpr void for_each_pass(auto&& pass) const {
        for (int i = 0; i < levels; ++i) pass(Level{edge, 1 << i});
    }
};
template <class... Fields> Atrous(Fields...) -> Atrous<typename detail::EdgeAmong<Product<DepthEdge, NormalEdge>, Fields...>::type>;

} // namespace quell
