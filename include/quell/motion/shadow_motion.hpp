#pragma once

#include <quell/motion/tangent_plane.hpp>

namespace quell {

/// Follows the shadow and not what it falls on (TRMV eq. 3): the line from where the light sample was through where the blocker was meets
/// the previous tangent plane of the receiver at the place where the same shadow was. Receiver, blocker and light may each move.
/// Valid only where the shadow ray was blocked; see SplattedShadowMotion for the pixels around. Invalid as well: a line nearly parallel to
/// the plane, an intersection before the blocker, one behind the camera, and anything not finite.
struct ShadowMotion {
    using reads = decltype(detail::TangentPlaneChannels{} | Channels<Light, LightPrevious, Blocker, BlockerPrevious>{});
    static constexpr bool needs_camera = true;
    float least_sine = 0.02f; ///< of the angle between the line and the plane

    QUELL_KERNEL auto previous(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const light = px[light_previous], blocker = px[blocker_previous];
        auto const line = blocker - light;
        auto const blocked = both(all_finite(px[quell::blocker]), all_finite(light), all_finite(blocker));
        if (!any(blocked)) return Reprojection<Real>{px.position(), Real(0.f)};
        auto const plane = detail::tangent_plane_then(px);
        auto const approach = dot(line, plane.normal), distance = dot(plane.point - light, plane.normal);
        auto const steep = abs(approach) > detail::length(line) * least_sine;
        // 1 is at the blocker.
        auto const t = distance / select(steep, approach, Real(1.f));
        auto const then = px.project_to_past(add_scaled(light, line, t));
        // A receiver that is its own blocker, at 1 itself, is a self-shadow.
        auto const valid = both(blocked, steep, t >= Real(0.999f), then.z > Real(0.f), is_finite(then.x), is_finite(then.y));
        return Reprojection<Real>{{then.x, then.y}, masked(valid, Real(1.f))};
    }
};

} // namespace quell
