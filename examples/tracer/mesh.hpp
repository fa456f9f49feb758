#pragma once

#include "math.hpp"

#include <functional>
#include <vector>

namespace quell::tracer {

/// Triangles, counter-clockwise seen from outside. Normals and texture coordinates may be absent.
struct TriangleMesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec2> uvs;
    std::vector<glm::uvec3> triangles;
};

/// Moves the vertices of a mesh (handed over at rest, without texture coordinates) to where they are at a moment.
using Deformation = std::function<void(float frame, TriangleMesh& mesh)>;

/// Linear-blend skinning: a vertex is the weighted mean of where its joints carry it. Such a mesh follows its joints, not its own node.
struct Skin {
    std::vector<int> joints; ///< nodes of the scene
    std::vector<glm::mat4> inverse_bind;
    std::vector<glm::uvec4> vertex_joints; ///< per vertex: four indices into `joints`
    std::vector<glm::vec4> vertex_weights;
};

/// What an instance shows: a mesh, or the exact sphere of radius 1 around the origin.
struct Shape {
    TriangleMesh mesh;
    Deformation deformation;
    Skin skin;
    bool is_sphere = false;

    [[nodiscard]] bool is_deforming() const { return deformation != nullptr || !skin.joints.empty(); }
};

/// The vertices of a skinned mesh, given each joint's matrix times its inverse bind matrix.
void apply_skin(Skin const& skin, std::vector<glm::mat4> const& joint_matrices, TriangleMesh& mesh);

/// Normals that are the angle-weighted mean of those of the adjoining faces.
void compute_normals(TriangleMesh& mesh);

} // namespace quell::tracer
