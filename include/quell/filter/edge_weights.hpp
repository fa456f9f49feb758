#pragma once

#include <quell/filter/filter_kernel.hpp>

namespace quell {

/// exp(-|dz| / (sigma |grad z . dp| + relative_floor z)): neighbours off the surface's own slope count less (SVGF's w_z). A miss has no
/// neighbours.
struct DepthEdge {
    using reads = Channels<Depth>;
    float sigma = 1.f;
    float relative_floor = 0.01f; ///< the change of depth, as a part of depth, that always passes at weight 1/e

    template <class Real>
    struct Around {
        Real z, slope_x, slope_y, floor;
        QUELL_KERNEL Real root(auto near, int dx, int dy) const {
            auto const along = abs(slope_x * static_cast<float>(dx) + slope_y * static_cast<float>(dy));
            return detail::root_of_exp(abs(near[depth] - z) * approximate_reciprocal(along + floor));
        }
    };
    QUELL_KERNEL auto around(auto px) const {
        auto const z = px[depth];
        auto const slope_x = slope(z, px.at(-1, 0)[depth], px.at(1, 0)[depth]), slope_y = slope(z, px.at(0, -1)[depth], px.at(0, 1)[depth]);
        return Around<decltype(z + z)>{z, slope_x * sigma, slope_y * sigma, max(z * relative_floor, decltype(z + z)(1e-12f))};
    }

private:
    /// The smaller one-sided difference: across a silhouette one of them is the edge, not the surface.
    template <class Real>
    QUELL_KERNEL static Real slope(Real z, Real before, Real after) {
        auto const back = z - before, forth = after - z;
        return select(abs(back) < abs(forth), back, forth);
    }
};

/// max(0, n . n')^128: neighbours that face another way count less (SVGF's w_n).
struct NormalEdge {
    using reads = Channels<Normal>;

    template <class Real>
    struct Around {
        vec3<Real> n;
        QUELL_KERNEL Real root(auto near, int, int) const {
            auto const cosine = max(dot(n, near[normal]), Real(0.f)), squared = cosine * cosine;
            return squared * squared;
        }
    };
    QUELL_KERNEL auto around(auto px) const { return Around<typename decltype(px)::Real>{px[normal]}; }
};

/// exp(-|dl| / (sigma * scale)): neighbours of another brightness count less, in absolute units.
struct LuminanceEdge {
    float sigma = 1.f;

    template <class Real>
    struct Around {
        Real centre;
        float inverse;
        QUELL_KERNEL Real root(auto near, int, int) const { return detail::root_of_exp(abs(luminance(near.signal()) - centre) * inverse); }
    };
    QUELL_KERNEL auto around(auto px) const { return Around<typename decltype(px)::Real>{luminance(px.signal()), 1.f / sigma}; }
};

/// exp(-|dl| / (sigma sqrt(variance) + 1e-4)) with the variance blurred by a 3x3 Gaussian: only differences beyond the noise are edges
/// (SVGF's w_l).
struct VarianceGuidedEdge {
    using reads = Channels<Variance>;
    float sigma = 4.f;

    template <class Real>
    struct Around {
        Real centre, inverse;
        QUELL_KERNEL Real root(auto near, int, int) const { return detail::root_of_exp(abs(luminance(near.signal()) - centre) * inverse); }
    };
    QUELL_KERNEL auto around(auto px) const {
        using Real = typename decltype(px)::Real;
        Real sum(0.f), weights(0.f);
        constexpr float profile[] = {0.5f, 0.25f};
        for_each_tap<1>(px, 1, profile, [&](auto near, auto weight, int, int) __attribute__((always_inline)) {
            sum = sum + near[variance] * weight;
            weights = weights + weight;
        });
        auto const deviation = sqrt(max(sum / weights, Real(0.f)));
        return Around<Real>{luminance(px.signal()), 1.f / (deviation * sigma + 1e-4f)};
    }
};

/// The product of several edge weights, which is one.
template <class... Edges>
struct Product : Edges... {
    static_assert((EdgeWeight<Edges> && ...), "Product{edges...}: each must have around(px), see quell/filter/filter_kernel.hpp");
    using reads = reads_of<Edges...>;

    template <class... Prepared>
    struct Around : Prepared... {
        QUELL_KERNEL auto root(auto near, int dx, int dy) const { return (... * Prepared::root(near, dx, dy)); }
    };
    QUELL_KERNEL auto around(auto px) const { return Around<decltype(Edges::around(px))...>{Edges::around(px)...}; }
};
template <class... Edges>
Product(Edges...) -> Product<Edges...>;

} // namespace quell
