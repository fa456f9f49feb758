#pragma once

#include <quell/filter/atrous.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// An EdgeWeight of 1 everywhere.
struct NoEdge {
    static constexpr int farthest_tap = 0;
    /// @cond
    struct Around {
        QUELL_KERNEL auto distance(auto, auto sum) const { return sum; }
    };
    /// @endcond
    /// See EdgeWeight.
    QUELL_KERNEL auto around(auto) const { return Around{}; }
};

namespace detail {
/// exp(-i^2 / (2 deviation^2)) for i = 1, 2, 3, ..., by two multiplications each.
template <class Real> struct GaussianSteps {
    Real weight, ratio, growth;
    QUELL_KERNEL explicit GaussianSteps(Real deviation)
        : weight(1.f), ratio(quell::exp(Real(-0.5f) / (deviation * deviation))), growth(ratio * ratio) {}
    QUELL_KERNEL Real next() {
        weight = weight * ratio;
        ratio = ratio * growth;
        return weight;
    }
};

/// One direction of a separable joint bilateral filter. `Deviation` gives the width, for the frame or per pixel.
template <class Edge, class Deviation> struct BilateralLine {
    static constexpr auto name = "bilateral";
    using parts = Parts<Edge, Deviation>;
    Edge edge;
    Deviation deviation;
    int radius;
    bool vertical;

    constexpr int farthest_tap() const { return radius; }

    QUELL_KERNEL auto filter(auto px) const {
        using Px = decltype(px);
        using Real = typename Px::Real;
        auto const around = edge.around(px);
        auto sum = px.signal();
        Real weights(1.f);
        GaussianSteps<Real> gaussian(deviation.of(px));
        for (int i = 1; i <= radius; ++i) {
            int const dx = vertical ? 0 : i, dy = vertical ? i : 0;
            auto const& toward = detail::edge_toward(around, dx, dy);
            // Smaller weights are 0, so that the result does not depend on where the other lanes of a pack stop.
            auto const gauss = gaussian.next();
            auto const reaches = gauss > Real(1e-7f);
            if (!any(reaches)) break;
            auto const falloff = masked(reaches, gauss);
            auto const add = [&](auto neighbour) QUELL_INLINED {
                auto const counts = both(neighbour.inside(), invert(neighbour.missing()));
                auto const w = masked(counts, falloff * edge_weight(toward.distance(neighbour, Real(detail::edge_offset(around)))));
                sum = add_scaled(sum, neighbour.signal(), w);
                weights = weights + w;
            };
            add(px.at(dx, dy));
            add(px.at(-dx, -dy));
        }
        return finite_or(scale(sum, 1.f / weights), px.signal());
    }
};

struct EvenDeviation {
    static constexpr int farthest_tap = 0;
    float pixels;
    QUELL_KERNEL auto of(auto px) const { return typename decltype(px)::Real(pixels); }
};
struct DeviationChannel {
    using reads = Channels<CleanUpDeviation>;
    static constexpr int farthest_tap = 0;
    QUELL_KERNEL auto of(auto px) const { return max(px[clean_up_deviation], typename decltype(px)::Real(0.05f)); }
};
} // namespace detail

/// Separable joint bilateral filter: a Gaussian that stops at edges, along rows and then along columns.
///
///     Bilateral<>{.radius = 15}
///
/// @tparam Edge an EdgeWeight
template <class Edge = Product<DepthEdge, NormalEdge>> struct Bilateral {
    static_assert(EdgeWeight<Edge>, "Bilateral{edge}: `edge` must have around(px), see quell/filter/filter_kernel.hpp");
    using parts = Parts<Edge>;
    Edge edge{};           ///< which neighbours count
    int radius = 4;        ///< pixels; 15 is a 31x31 filter
    float deviation = 0.f; ///< standard deviation of the Gaussian, in pixels; 0: half the radius

    /// Rows, then columns.
    constexpr void for_each_pass(auto&& pass) const {
        using Line = detail::BilateralLine<Edge, detail::EvenDeviation>;
        detail::EvenDeviation const width{deviation > 0.f ? deviation : max(0.5f * static_cast<float>(radius), 0.5f)};
        pass(Line{edge, width, radius, false});
        pass(Line{edge, width, radius, true});
    }
};
template <class... Fields> Bilateral(Fields...) -> Bilateral<typename detail::EdgeAmong<Product<DepthEdge, NormalEdge>, Fields...>::type>;

/// A separable Gaussian blur.
struct Gaussian {
    int radius = 4;        ///< pixels
    float deviation = 0.f; ///< standard deviation, in pixels; 0: half the radius

    /// Rows, then columns.
    constexpr void for_each_pass(auto&& pass) const { Bilateral<NoEdge>{NoEdge{}, radius, deviation}.for_each_pass(pass); }
};

/// A Bilateral filter with a width per pixel.
///
///     AdaptiveBilateral<PenumbraWidth>{.radius = 15}
///
/// @tparam Width has of(px): the standard deviation of the Gaussian, in pixels, above 0
/// @tparam Edge  an EdgeWeight
template <class Width, class Edge = Product<DepthEdge, NormalEdge>> struct AdaptiveBilateral {
    static_assert(EdgeWeight<Edge>, "AdaptiveBilateral{width, edge}: `edge` must have around(px), see quell/filter/filter_kernel.hpp");
    /// @cond
    using Line = detail::BilateralLine<Edge, Width>;
    using parts = Parts<Line>;
    /// @endcond
    Width width{};  ///< the width of each pixel
    Edge edge{};    ///< which neighbours count
    int radius = 4; ///< in pixels; wider Gaussians are cut off there

    /// Rows, then columns.
    constexpr void for_each_pass(auto&& pass) const {
        pass(Line{edge, width, radius, false});
        pass(Line{edge, width, radius, true});
    }
};

/// Removes the noise that a short or clamped history leaves: a joint bilateral filter of at most 9x9, with a width per pixel (TRMV section
/// 5). Goes after a Temporal with WithCleanUp, which says the width.
/// @tparam Edge an EdgeWeight
template <class Edge = Product<DepthEdge, NormalEdge>> struct CleanUp {
    static_assert(EdgeWeight<Edge>, "CleanUp{edge}: `edge` must have around(px), see quell/filter/filter_kernel.hpp");
    using parts = Parts<detail::BilateralLine<Edge, detail::DeviationChannel>>;
    Edge edge{}; ///< which neighbours count

    /// Rows, then columns.
    constexpr void for_each_pass(auto&& pass) const { AdaptiveBilateral<detail::DeviationChannel, Edge>{{}, edge, 4}.for_each_pass(pass); }
};
template <class Edge> CleanUp(Edge) -> CleanUp<Edge>;

} // namespace quell::inline QUELL_INSTRUCTION_SET
