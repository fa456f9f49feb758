#pragma once

#include <quell/blend/part_of_past.hpp>
#include <quell/motion/tangent_plane.hpp>

namespace quell {

/// Trusts a past less that was found on a surface which doesn't continue this one's plane (TRMV eq. 4): alpha becomes
/// 1 - G(theta - pi / 2) (1 - alpha), where theta lies between the normal here and the direction to the surface that the previous frame
/// shows where the past was found. For shadows, whose motion is worked out as if their receivers were planes.
///     NonPlanarFalloff{Exponential{.alpha = 0.1f}}
template <class Inner> struct NonPlanarFalloff {
    static_assert(BlendPolicy<Inner>, "NonPlanarFalloff{inner}: `inner` must have blend(px, past), see quell/blend/blend_policy.hpp");
    using parts = Parts<Inner>;
    using reads = decltype(detail::TangentPlaneChannels{} | Channels<Depth>{});
    using remembers = Channels<Depth>;
    static constexpr bool needs_camera = true;
    Inner inner{};
    float deviation = 0.1f; ///< of the angle, in radians

    QUELL_KERNEL auto blend(auto px, auto past) const {
        using Real = typename decltype(px)::Real;
        if (!any(past.validity > Real(0.f))) return inner.blend(px, past);
        auto const place = nearest_place(px, past.where);
        auto const found = px.past(place);
        auto const z = found[depth];
        auto const plane = detail::tangent_plane_then(px);
        auto const way = px.rays_then().position(found.sample_position(), z) - plane.point;
        auto const distance = detail::length(way);
        // Within two pixels the direction is that of rounding, not of the surface.
        auto const close_by = distance < px[depth] * (2.f * px.rays().pixel_size);
        // For small angles off the plane, theta - pi / 2 is the sine. It is no number where now or then nothing is seen.
        auto const sine = dot(way, plane.normal) / max(distance, Real(1e-20f));
        auto const g = exp(sine * sine * (-0.5f / (deviation * deviation)));
        // Nothing is known of a surface that was nowhere, or farther away than numbers reach.
        auto const known = both(is_finite(z), is_finite(distance), is_finite(sine * sine));
        return detail::blend_part_of_past(inner, px, past, masked(known, select(close_by, Real(1.f), g)));
    }
};
template <class Inner> NonPlanarFalloff(Inner) -> NonPlanarFalloff<Inner>;

} // namespace quell
