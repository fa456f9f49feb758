#pragma once

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cmath>
#include <limits>
#include <numbers>

namespace quell::tracer {

inline constexpr float pi = std::numbers::pi_v<float>;
inline constexpr float infinity = std::numeric_limits<float>::infinity();
inline constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

/// A direction at unit length, or another where it has none.
inline glm::vec3 unit_or(glm::vec3 direction, glm::vec3 otherwise) {
    float const length = glm::length(direction);
    return length > 0 && std::isfinite(length) ? direction / length : otherwise;
}

/// Two directions that complete a unit vector to a right-handed frame (Duff et al., "Building an orthonormal basis, revisited", 2017).
struct Basis {
    glm::vec3 x, y, z;

    explicit Basis(glm::vec3 axis) : x(0.f), y(0.f), z(axis) {
        float const sign = std::copysign(1.f, axis.z), a = -1 / (sign + axis.z), b = axis.x * axis.y * a;
        x = {1 + sign * axis.x * axis.x * a, sign * b, -sign * axis.x};
        y = {b, sign + axis.y * axis.y * a, -axis.y};
    }
    [[nodiscard]] glm::vec3 world(glm::vec3 local) const { return x * local.x + y * local.y + z * local.z; }
};

} // namespace quell::tracer
