#pragma once

#include "trace.hpp"
#include "view.hpp"

namespace quell::tracer {

/// A plane through a point, with a unit normal; it stands for a surface close to the point.
struct Plane {
    glm::vec3 point, normal;

    [[nodiscard]] glm::vec3 mirrored(glm::vec3 position) const { return position - 2 * glm::dot(position - point, normal) * normal; }
};

/// Where the line from the light through the blocker meets the plane, if it does so beyond the blocker; otherwise NaN.
inline glm::vec3 shadow_on(Plane const& plane, glm::vec3 light, glm::vec3 blocker) {
    auto const direction = blocker - light;
    float const towards = glm::dot(direction, plane.normal), part = glm::dot(plane.point - light, plane.normal) / towards;
    return part >= 1 ? light + part * direction : glm::vec3{not_a_number};
}

/// A point that a primary ray met, and a moment of the open shutter at which to look at it.
struct ShutterMoment {
    PreparedScene const& scene;
    Hit const& hit;
    View const& view; ///< at that moment
    float time;
};

/// Where the image shows the shadow that the sample found on the point at `sampled_at`: where the line from the light through the blocker
/// meets the receiver's tangent plane, all of them as they are at the moment. NaN without a blocker, and where the line meets nothing or
/// almost grazes the plane.
[[nodiscard]] glm::vec2 shadow_place(ShutterMoment const& moment, Signals const& signals, float sampled_at);

/// Where the image shows what the sample found reflected, in a flat mirror in place of the point. NaN where nothing is reflected.
[[nodiscard]] glm::vec2 reflection_place(ShutterMoment const& moment, Signals const& signals);

} // namespace quell::tracer
