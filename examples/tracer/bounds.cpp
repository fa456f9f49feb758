#include "bounds.hpp"

namespace quell::tracer {
namespace {

void include_sphere(glm::mat4 const& matrix, Bounds& bounds) {
    for (int axis = 0; axis < 3; ++axis) {
        float const reach = glm::length(glm::vec3{matrix[0][axis], matrix[1][axis], matrix[2][axis]});
        for (float side : {-reach, reach}) {
            glm::vec3 point{matrix[3]};
            point[axis] += side;
            bounds.include(point);
        }
    }
}

} // namespace

Bounds bounds_of(SceneDescription const& scene, float frame) {
    Bounds bounds;
    for (auto const& instance : scene.instances) {
        auto const& shape = scene.shapes[static_cast<std::size_t>(instance.shape)];
        auto const matrix = scene.node_matrix(instance.node, frame);
        if (shape.is_sphere)
            include_sphere(matrix, bounds);
        else
            for (auto const& position : scene.vertices_at(shape, frame).positions) bounds.include(matrix * glm::vec4(position, 1.f));
    }
    return bounds;
}

} // namespace quell::tracer
