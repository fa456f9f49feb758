#pragma once

#include "ray.hpp"

#include <glm/geometric.hpp>

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

} // namespace quell::tracer
