#pragma once

#include "mesh.hpp"

#include <functional>

namespace quell::tracer {

// Meshes to build scenes from. Unless said otherwise they are centred on the origin.

/// A rectangle in the plane y = 0 that faces up. `repeats`: how often a texture lies along each side.
[[nodiscard]] TriangleMesh rectangle(float width, float depth, glm::vec2 repeats = {1, 1});
/// `density`: how often a texture repeats per unit of length; 0 means once on each face.
[[nodiscard]] TriangleMesh box(glm::vec3 size, float density = 0);
/// A surface of revolution around y from points (radius, height) in order from bottom to top; smooth along and around.
[[nodiscard]] TriangleMesh turned(std::vector<glm::vec2> const& profile, int segments = 48);
/// A cylinder or cone standing on y = 0, with its ends closed.
[[nodiscard]] TriangleMesh cylinder(float bottom_radius, float top_radius, float height, int segments = 48);
/// A ring around y.
[[nodiscard]] TriangleMesh torus(float radius, float tube_radius, int segments = 64, int tube_segments = 24);
/// A grid of points over u and v in [0, 1], with smooth normals.
[[nodiscard]] TriangleMesh surface(int columns, int rows, std::function<glm::vec3(float u, float v)> const& point);

/// Both meshes in one.
[[nodiscard]] TriangleMesh joined(TriangleMesh first, TriangleMesh const& second);
[[nodiscard]] TriangleMesh moved(TriangleMesh mesh, glm::vec3 offset);

} // namespace quell::tracer
