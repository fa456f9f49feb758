#include "mesh.hpp"
#include "ray.hpp"

namespace quell::tracer {
namespace {

glm::mat4 blended(Skin const& skin, std::vector<glm::mat4> const& joint_matrices, std::size_t vertex) {
    auto const joints = skin.vertex_joints[vertex];
    auto const weights = skin.vertex_weights[vertex];
    glm::mat4 sum{0.f};
    for (int i = 0; i < 4; ++i)
        if (weights[i] > 0) sum += joint_matrices[joints[i]] * weights[i];
    return sum;
}

} // namespace

void apply_skin(Skin const& skin, std::vector<glm::mat4> const& joint_matrices, TriangleMesh& mesh) {
    for (std::size_t vertex = 0; vertex < mesh.positions.size(); ++vertex) {
        auto const matrix = blended(skin, joint_matrices, vertex);
        mesh.positions[vertex] = matrix * glm::vec4(mesh.positions[vertex], 1.f);
        // Joints of characters turn and scale evenly, for which the matrix itself serves as well as its inverse transpose.
        if (!mesh.normals.empty()) mesh.normals[vertex] = unit_or(glm::mat3(matrix) * mesh.normals[vertex], {0, 1, 0});
    }
}

void compute_normals(TriangleMesh& mesh) {
    mesh.normals.assign(mesh.positions.size(), glm::vec3{0.f});
    for (auto const& triangle : mesh.triangles)
        for (int i = 0; i < 3; ++i) {
            auto const corner = mesh.positions[triangle[i]];
            auto const a = unit_or(mesh.positions[triangle[(i + 1) % 3]] - corner, glm::vec3{0.f});
            auto const b = unit_or(mesh.positions[triangle[(i + 2) % 3]] - corner, glm::vec3{0.f});
            auto const cross = glm::cross(a, b);
            mesh.normals[triangle[i]] += unit_or(cross, glm::vec3{0.f}) * std::atan2(glm::length(cross), glm::dot(a, b));
        }
    for (auto& normal : mesh.normals) normal = unit_or(normal, {0, 1, 0});
}

} // namespace quell::tracer
