#pragma once

#include <glm/gtc/quaternion.hpp>

#include <numbers>

namespace quell::tracer {

inline constexpr float pi = std::numbers::pi_v<float>;

/// A rotation around an axis through the origin.
[[nodiscard]] inline glm::quat turn(float degrees, glm::vec3 axis) { return glm::angleAxis(degrees * pi / 180, glm::normalize(axis)); }

} // namespace quell::tracer
