#pragma once

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <numbers>

namespace quell::tracer {

inline constexpr float pi = std::numbers::pi_v<float>;

/// A rotation around an axis through the origin.
[[nodiscard]] inline glm::quat turn(float degrees, glm::vec3 axis) { return glm::angleAxis(degrees * pi / 180, glm::normalize(axis)); }

/// The shortest rotation that makes what faces up, as rectangles do, face this direction.
[[nodiscard]] inline glm::quat facing(glm::vec3 direction) {
    auto const to = glm::normalize(direction);
    if (to.y < -0.9999f) return turn(180, {1, 0, 0});
    return glm::normalize(glm::quat(1 + to.y, glm::cross(glm::vec3{0, 1, 0}, to)));
}

} // namespace quell::tracer
