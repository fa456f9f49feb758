#pragma once

#include <quell/motion/tangent_plane.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Follows the shadow instead of the receiver (TRMV eq. 3). The line through the previous positions of the light sample and the blocker is
/// intersected with the previous tangent plane of the receiver: the same shadow fell there. Receiver, blocker and light may each move.
/// Validity is 1 where the shadow ray was blocked, else 0; SplattedShadowMotion serves the pixels around. Also 0: a line nearly parallel to
/// the plane, an intersection in front of the blocker or behind the camera, and positions that are not finite.
struct ShadowMotion {
    using reads = decltype(detail::TangentPlaneChannels{} | Channels<Light, LightPrevious, Blocker, BlockerPrevious>{}); ///< of this frame
    static constexpr bool needs_camera = true;                                                                           ///< to project
    static constexpr int farthest_tap = 1;
    float min_sine = 0.02f; ///< least sine of the angle between line and plane

    /// See MotionSource.
    QUELL_KERNEL auto previous(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const light_then = px[light_previous], blocker_then = px[blocker_previous];
        auto const line = blocker_then - light_then;
        auto const blocked = both(all_finite(px[blocker]), all_finite(light_then), all_finite(blocker_then));
        if (!any(blocked)) return Reprojection<Real>{px.position(), Real(0.f)};
        auto const plane = detail::tangent_plane_then(px);
        auto const approach = dot(line, plane.normal), distance = dot(plane.point - light_then, plane.normal);
        auto const steep = abs(approach) > detail::length(line) * min_sine;
        // t = 0 is the light sample, t = 1 the blocker.
        auto const t = distance / select(steep, approach, Real(1.f));
        auto const then = px.project_to_past(add_scaled(light_then, line, t));
        // t = 1: the receiver is its own blocker, a self-shadow. Rounding may leave t slightly below.
        auto const valid = both(blocked, steep, t >= Real(0.999f), then.z > Real(0.f), is_finite(then.x), is_finite(then.y));
        return Reprojection<Real>{{then.x, then.y}, masked(valid, Real(1.f))};
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
