#pragma once

#include <quell/filter/edge_weights.hpp>
#include <quell/motion/tangent_plane.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// For glossy reflections: neighbours count as far as the reflection itself is blurred, exp(-(dx^2 + dy^2) / (2 w^2)). w is the width of
/// the GGX lobe at the hit, seen from the camera, in pixels. Mirrors and reflections of what touches the surface stay sharp.
///
///     VarianceGuidedAtrous{Product{DepthEdge{}, NormalEdge{}, LobeEdge{}}}
struct LobeEdge {
    using reads = Channels<Roughness, GlossyHit, Position, Depth>;
    static constexpr bool needs_camera = true;
    static constexpr int farthest_tap = 0;
    float width = 2.f;      ///< w in GGX alphas (squared roughness) times the distance to the hit
    float min_width = 0.3f; ///< least w, in pixels

    /// @cond
    template <class Real> struct Around {
        Real falloff;
        QUELL_KERNEL auto toward(int dx, int dy) const { return Toward{falloff * static_cast<float>(dx * dx + dy * dy)}; }
        struct Toward {
            Real away;
            QUELL_KERNEL Real distance(auto const&, Real sum) const { return sum + away; }
        };
    };
    /// @endcond
    /// See EdgeWeight.
    QUELL_KERNEL auto around(auto const& px) const {
        using Real = typename std::remove_cvref_t<decltype(px)>::Real;
        auto const z = px[depth], way = detail::length(px[glossy_hit] - px[position]);
        // The hit is `away` from the surface and z + away from the camera, if it lies straight behind.
        auto const away = select(is_finite(way), way, z * 1e3f);
        auto const pixels = px[roughness] * px[roughness] * width * away / ((z + away) * px.rays().pixel_size);
        auto const w = max(masked(is_finite(pixels), pixels), Real(min_width));
        return Around<Real>{Real(0.5f) / (w * w)};
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
