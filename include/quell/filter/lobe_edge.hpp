#pragma once

#include <quell/filter/edge_weights.hpp>
#include <quell/motion/tangent_plane.hpp>

namespace quell {

/// For glossy reflections: neighbours count as far as the reflection's own blur reaches, exp(-(dx^2 + dy^2) / (2 w^2)), w being the lobe's
/// width where it meets what was hit, as seen from the camera: a mirror is not filtered at all, and what touches a rough surface hardly.
///     VarianceGuidedAtrous{Product{DepthEdge{}, NormalEdge{}, LobeEdge{}}}
struct LobeEdge {
    using reads = Channels<Roughness, GlossyHit, Position, Depth>;
    static constexpr bool needs_camera = true;
    float width = 2.f;  ///< of the Gaussian, in GGX alphas at the hit
    float least = 0.3f; ///< pixels

    template <class Real> struct Around {
        Real falloff;
        QUELL_KERNEL auto toward(int dx, int dy) const { return Toward{falloff * static_cast<float>(dx * dx + dy * dy)}; }
        struct Toward {
            Real away;
            QUELL_KERNEL Real distance(auto const&, Real sum) const { return sum + away; }
        };
    };
    QUELL_KERNEL auto around(auto const& px) const {
        using Real = typename std::remove_cvref_t<decltype(px)>::Real;
        auto const z = px[depth], way = detail::length(px[glossy_hit] - px[position]);
        // The surface sees the hit as far away as it is, the camera sees surface and hit one behind the other: a near camera magnifies.
        auto const away = select(is_finite(way), way, z * 1e3f);
        auto const pixels = px[roughness] * px[roughness] * width * away / ((z + away) * px.rays().pixel_size);
        auto const w = max(masked(is_finite(pixels), pixels), Real(least));
        return Around<Real>{Real(0.5f) / (w * w)};
    }
};

} // namespace quell
