#pragma once

#include "scene.hpp"

namespace quell::tracer {

/// An axis-aligned box around something.
struct Bounds {
    glm::vec3 least{1e30f}, most{-1e30f};

    void include(glm::vec3 point) {
        least = glm::min(least, point);
        most = glm::max(most, point);
    }
    /// The unit sphere around the origin, placed somewhere.
    void include_sphere(glm::mat4 const& matrix) {
        for (int axis = 0; axis < 3; ++axis) {
            float const reach = glm::length(glm::vec3{matrix[0][axis], matrix[1][axis], matrix[2][axis]});
            for (float side : {-reach, reach}) {
                glm::vec3 point{matrix[3]};
                point[axis] += side;
                include(point);
            }
        }
    }
    [[nodiscard]] glm::vec3 centre() const { return (least + most) * 0.5f; }
    [[nodiscard]] float radius() const { return glm::max(glm::length(most - least) * 0.5f, 1e-6f); }
};

/// A box around all instances at a frame.
[[nodiscard]] inline Bounds bounds_of(SceneDescription const& scene, float frame) {
    Bounds bounds;
    for (auto const& instance : scene.instances) {
        auto const& shape = scene.shapes[static_cast<std::size_t>(instance.shape)];
        auto const matrix = scene.node_matrix(instance.node, frame);
        if (shape.is_sphere)
            bounds.include_sphere(matrix);
        else
            for (auto const& position : scene.vertices_at(shape, frame).positions) bounds.include(matrix * glm::vec4(position, 1.f));
    }
    return bounds;
}

} // namespace quell::tracer
