#pragma once

#include <quell/filter/edge_taps.hpp>
#include <quell/frame/cursor/depth_slope.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Neighbours off the surface's slope in depth weigh less: exp(-|dz| / (sigma |grad z . dp| + relative_floor z)) (w_z of Schied et al.
/// 2017). A miss has no neighbours.
struct DepthEdge {
    using reads = Channels<Depth>;
    static constexpr int farthest_tap = 1;
    float sigma = 1.f;            ///< multiple of the slope that has weight 1/e
    float relative_floor = 0.01f; ///< difference with weight 1/e on a surface without slope, as a part of depth

    /// @cond
    template <class Real> struct Toward {
        Real z, inverse;
        QUELL_KERNEL Real distance(auto neighbour, Real sum) const { return fma(abs(neighbour[depth] - z), inverse, sum); }
    };
    template <class Real> struct Around {
        Real z, slope_x, slope_y, floor;
        QUELL_KERNEL auto toward(int dx, int dy) const {
            auto const along = abs(fma(slope_x, Real(static_cast<float>(dx)), slope_y * static_cast<float>(dy)));
            return Toward<Real>{z, approximate_reciprocal(along + floor)};
        }
    };
    /// @endcond
    /// See EdgeWeight.
    QUELL_KERNEL auto around(auto px) const {
        auto const z = px[depth];
        auto const slope_x = detail::depth_slope(px, 1, 0), slope_y = detail::depth_slope(px, 0, 1);
        return Around<decltype(z + z)>{z, slope_x * sigma, slope_y * sigma, max(z * relative_floor, decltype(z + z)(1e-12f))};
    }
};

/// Neighbours with another normal weigh less: exp(-sharpness (1 - n . n')). At 128 this is max(0, n . n')^128 (w_n of Schied et al. 2017)
/// to within 0.003.
struct NormalEdge {
    using reads = Channels<Normal>;
    static constexpr int farthest_tap = 0;
    float sharpness = 128.f; ///< larger: normals must agree better; 0: they do not matter

    /// @cond
    template <class Real> struct Around {
        vec3<Real> n; // times -sharpness
        float sharpness;
        QUELL_KERNEL float offset() const { return sharpness; }
        QUELL_KERNEL Real distance(auto neighbour, Real sum) const {
            auto const there = neighbour[normal];
            return fma(n.x, there.x, fma(n.y, there.y, fma(n.z, there.z, sum)));
        }
    };
    /// @endcond
    /// See EdgeWeight.
    QUELL_KERNEL auto around(auto px) const {
        auto const n = px[normal];
        return Around<typename decltype(px)::Real>{{n.x * -sharpness, n.y * -sharpness, n.z * -sharpness}, sharpness};
    }
};

namespace detail {
/// What LuminanceEdge and VarianceGuidedEdge prepare. The distance is |difference of luminance| * inverse.
template <class Real> struct AroundLuminance {
    Real minus_centre, inverse;
    QUELL_KERNEL Real distance(auto neighbour, Real sum) const {
        return fma(abs(luminance_plus(neighbour.signal(), minus_centre)), inverse, sum);
    }
};
} // namespace detail

/// Neighbours of another luminance weigh less: exp(-|dl| / sigma).
struct LuminanceEdge {
    static constexpr int farthest_tap = 0;
    float sigma = 1.f; ///< difference with weight 1/e, in units of the signal

    /// See EdgeWeight.
    QUELL_KERNEL auto around(auto px) const {
        using Real = typename decltype(px)::Real;
        return detail::AroundLuminance<Real>{-luminance(px.signal()), Real(1.f / sigma)};
    }
};

/// Only differences of luminance beyond the noise weigh less: exp(-|dl| / (sigma sqrt(variance) + 1e-4 |l|)), with the variance blurred by
/// a 3x3 Gaussian (w_l of Schied et al. 2017, where a constant stands in place of 1e-4 |l|: light may be of any unit here).
struct VarianceGuidedEdge {
    using reads = Channels<Variance>;
    static constexpr int farthest_tap = 1;
    float sigma = 4.f; ///< difference with weight 1/e, in standard deviations

    /// See EdgeWeight.
    QUELL_KERNEL auto around(auto px) const {
        using Real = typename decltype(px)::Real;
        Real sum = px[variance] * 0.25f, weights(0.25f);
        constexpr float profile[] = {0.5f, 0.25f};
        for_each_tap_pair<1>(px, 1, profile, [&](auto neighbour, auto weight, auto opposite, auto its_weight, int, int) QUELL_INLINED {
            sum = fma(neighbour[variance], weight, fma(opposite[variance], its_weight, sum));
            weights = weights + (weight + its_weight);
        });
        auto const deviation = sqrt(max(sum / weights, Real(0.f))), its_luminance = luminance(px.signal());
        auto const tolerated = fma(abs(its_luminance), Real(1e-4f), deviation * sigma);
        return detail::AroundLuminance<Real>{-its_luminance, 1.f / max(tolerated, Real(1e-37f))};
    }
};

/// The product of several edge weights, itself an edge weight: their distances are added.
///
///     Product{DepthEdge{}, NormalEdge{.sharpness = 32.f}}
///
/// @tparam Edges each an EdgeWeight
template <class... Edges> struct Product : Edges... {
    static_assert((EdgeWeight<Edges> && ...), "Product{edges...}: each must have around(px), see quell/filter/filter_kernel.hpp");
    using parts = Parts<Edges...>;

    /// @cond
    // What each edge has prepared, as a base class by the edge: two edges may prepare the same type. Holds references where it can: copies
    // of GLM vectors go through memory.
    template <class Edge, class T> struct Held { T held; };
    template <class... Prepared> struct Toward : Held<Edges, Prepared>... {
        QUELL_KERNEL auto distance(auto const& neighbour, auto sum) const {
            ((sum = Held<Edges, Prepared>::held.distance(neighbour, sum)), ...);
            return sum;
        }
    };
    template <class... Prepared> struct Around : Held<Edges, Prepared>... {
        QUELL_KERNEL float offset() const { return (detail::edge_offset(Held<Edges, Prepared>::held) + ... + 0.f); }
        QUELL_KERNEL auto toward(int dx, int dy) const {
            return Toward<decltype(detail::edge_toward(std::declval<Prepared const&>(), dx, dy))...>{
                {detail::edge_toward(Held<Edges, Prepared>::held, dx, dy)}...};
        }
    };
    /// @endcond
    /// See EdgeWeight.
    QUELL_KERNEL auto around(auto px) const { return Around<decltype(Edges::around(px))...>{{Edges::around(px)}...}; }
};
template <class... Edges> Product(Edges...) -> Product<Edges...>;
template <class... Edges> inline constexpr bool detail::adds_no_tap<Product<Edges...>> = true;

} // namespace quell::inline QUELL_INSTRUCTION_SET
