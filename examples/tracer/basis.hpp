#pragma once

#include <glm/vec3.hpp>

#include <cmath>

namespace quell::tracer {

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
