#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cmath>

namespace quell::tracer {

/// A direction at unit length, or another where it has none.
inline glm::vec3 unit_or(glm::vec3 direction, glm::vec3 otherwise) {
    float const length = glm::length(direction);
    return length > 0 && std::isfinite(length) ? direction / length : otherwise;
}

} // namespace quell::tracer
