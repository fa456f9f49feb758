#pragma once

#include "scene.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace quell::tracer {

/// An axis-aligned box around something.
struct Bounds {
    glm::vec3 least{1e30f}, most{-1e30f};

    void include(glm::vec3 point) {
        least = glm::min(least, point);
        most = glm::max(most, point);
    }
    [[nodiscard]] glm::vec3 centre() const { return (least + most) * 0.5f; }
    [[nodiscard]] float radius() const { return glm::max(glm::length(most - least) * 0.5f, 1e-6f); }
};

/// A box around all instances at a frame.
[[nodiscard]] Bounds bounds_of(SceneDescription const& scene, float frame);

} // namespace quell::tracer
