#pragma once

#include <quell/blend/part_of_past.hpp>
#include <quell/motion/tangent_plane.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Reduces the weight of a history that was found off this pixel's tangent plane (TRMV eq. 4): alpha becomes 1 - G(theta - pi / 2) (1 -
/// alpha). theta is the angle between the normal and the direction to the surface that the previous frame shows at the place of the
/// history; G is a Gaussian. For shadows: their motion vectors assume planar receivers.
///
///     NonPlanarFalloff{Exponential{.alpha = 0.1f}}
///
/// @tparam Inner a BlendPolicy
template <class Inner> struct NonPlanarFalloff {
    static_assert(BlendPolicy<Inner>, "NonPlanarFalloff{inner}: `inner` must have blend(px, past), see quell/blend/blend_policy.hpp");
    using parts = Parts<Inner>;
    using reads = decltype(detail::TangentPlaneChannels{} | Channels<Depth>{});
    using remembers = Channels<Depth>;
    static constexpr bool needs_camera = true;
    static constexpr int farthest_tap = 1;
    Inner inner{};          ///< blends with the reduced weight
    float deviation = 0.1f; ///< of G, in radians

    /// The inner policy's result with the reduced weight; as it is where there is no history.
    QUELL_KERNEL auto blend(auto px, auto past) const {
        using Real = typename decltype(px)::Real;
        if (!any(past.validity > Real(0.f))) return inner.blend(px, past);
        auto const place = nearest_place(px, past.where);
        auto const found = px.past(place);
        auto const z = found[depth];
        auto const plane = detail::tangent_plane_then(px);
        auto const way = px.rays_then().position(found.sample_position(), z) - plane.point;
        auto const distance = detail::length(way);
        // Within two pixels, rounding decides the direction.
        auto const close_by = distance < px[depth] * (2.f * px.rays().pixel_size);
        // For small angles theta - pi / 2 is the sine, up to its sign. It is NaN where either frame shows a miss.
        auto const sine = dot(way, plane.normal) / max(distance, Real(1e-20f));
        auto const g = quell::exp(sine * sine * (-0.5f / (deviation * deviation)));
        // Misses, and surfaces beyond the range of floats, get weight 0.
        auto const known = both(is_finite(z), is_finite(distance), is_finite(sine * sine));
        return detail::blend_part_of_past(inner, px, past, masked(known, select(close_by, Real(1.f), g)));
    }
};
template <class Inner> NonPlanarFalloff(Inner) -> NonPlanarFalloff<Inner>;

} // namespace quell::inline QUELL_INSTRUCTION_SET
