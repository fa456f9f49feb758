#pragma once

#include "../math.hpp"

namespace quell::tracer {

/// A rotation around an axis through the origin.
[[nodiscard]] inline glm::quat turn(float degrees, glm::vec3 axis) { return glm::angleAxis(degrees * pi / 180, glm::normalize(axis)); }

/// What makes a rectangle, which faces up, face +z, and down.
inline glm::quat const upright = turn(90, {1, 0, 0}), upside_down = turn(180, {1, 0, 0});

/// The shortest rotation that makes what faces up, as rectangles do, face this direction.
[[nodiscard]] inline glm::quat facing(glm::vec3 direction) {
    auto const to = glm::normalize(direction);
    if (to.y < -0.9999f) return upside_down;
    return glm::normalize(glm::quat(1 + to.y, glm::cross(glm::vec3{0, 1, 0}, to)));
}

/// To and fro between -1 and 1, at a nearly constant speed but for the ends, where it turns smoothly. One turn is once there and back; it
/// starts in the middle, upwards.
[[nodiscard]] inline float shuttle(float turns) {
    constexpr float roundness = 0.98f; // 1 would be a triangle, 0 a sine
    return std::asin(roundness * std::sin(2 * pi * turns)) / std::asin(roundness);
}

} // namespace quell::tracer
