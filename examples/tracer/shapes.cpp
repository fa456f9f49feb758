#include "shapes.hpp"

#include <array>

namespace quell::tracer {
namespace {

/// A flat quadrilateral with corners in counter-clockwise order.
void add_quadrilateral(TriangleMesh& mesh, std::array<glm::vec3, 4> const& corners, glm::vec2 repeats) {
    auto const first = static_cast<unsigned>(mesh.positions.size());
    auto const normal = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
    std::array<glm::vec2, 4> const uvs{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    for (std::size_t i = 0; i < 4; ++i) {
        mesh.positions.push_back(corners[i]);
        mesh.normals.push_back(normal);
        mesh.uvs.push_back(uvs[i] * repeats);
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
}

} // namespace

TriangleMesh rectangle(float width, float depth, glm::vec2 repeats) {
    TriangleMesh mesh;
    float const x = width / 2, z = depth / 2;
    add_quadrilateral(mesh, {{{-x, 0, z}, {x, 0, z}, {x, 0, -z}, {-x, 0, -z}}}, repeats);
    return mesh;
}

TriangleMesh box(glm::vec3 size, float density) {
    TriangleMesh mesh;
    auto const half = size * 0.5f;
    for (int axis = 0; axis < 3; ++axis)
        for (float side : {-1.f, 1.f}) {
            glm::vec3 normal{0.f}, u{0.f}, v{0.f};
            normal[axis] = side * half[axis];
            u[(axis + 1) % 3] = side * half[(axis + 1) % 3];
            v[(axis + 2) % 3] = half[(axis + 2) % 3];
            auto const repeats = density > 0 ? glm::vec2{size[(axis + 1) % 3], size[(axis + 2) % 3]} * density : glm::vec2{1.f};
            add_quadrilateral(mesh, {normal - u - v, normal + u - v, normal + u + v, normal - u + v}, repeats);
        }
    return mesh;
}

TriangleMesh surface(int columns, int rows, std::function<glm::vec3(float, float)> const& point) {
    TriangleMesh mesh;
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= columns; ++column) {
            glm::vec2 const uv{static_cast<float>(column) / static_cast<float>(columns),
                               static_cast<float>(row) / static_cast<float>(rows)};
            mesh.positions.push_back(point(uv.x, uv.y));
            mesh.uvs.push_back(uv);
        }
    auto const index = [&](int column, int row) { return static_cast<unsigned>(row * (columns + 1) + column); };
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            mesh.triangles.push_back({index(column, row), index(column + 1, row), index(column + 1, row + 1)});
            mesh.triangles.push_back({index(column, row), index(column + 1, row + 1), index(column, row + 1)});
        }
    compute_normals(mesh);
    return mesh;
}

TriangleMesh turned(std::vector<glm::vec2> const& profile, int segments) {
    auto const rows = static_cast<int>(profile.size()) - 1;
    auto mesh = surface(segments, rows, [&](float u, float v) {
        auto const place = profile[static_cast<std::size_t>(std::lround(v * static_cast<float>(rows)))];
        float const angle = 2 * pi * u;
        return glm::vec3{place.x * std::sin(angle), place.y, place.x * std::cos(angle)};
    });
    // The seam's two columns of vertices are one line on the surface.
    auto const columns = static_cast<std::size_t>(segments) + 1;
    for (std::size_t first = 0; first + columns <= mesh.normals.size(); first += columns) {
        auto const sum = mesh.normals[first] + mesh.normals[first + columns - 1];
        if (glm::length(sum) > 0) mesh.normals[first] = mesh.normals[first + columns - 1] = glm::normalize(sum);
    }
    return mesh;
}

TriangleMesh cylinder(float bottom_radius, float top_radius, float height, int segments) {
    auto const side = turned({{bottom_radius, 0}, {top_radius, height}}, segments);
    auto const bottom = turned({{0, 0}, {bottom_radius, 0}}, segments), top = turned({{top_radius, height}, {0, height}}, segments);
    return joined(joined(side, bottom), top);
}

TriangleMesh torus(float radius, float tube_radius, int segments, int tube_segments) {
    return surface(segments, tube_segments, [&](float u, float v) {
        float const around = 2 * pi * u, tube = 2 * pi * v, distance = radius + tube_radius * std::cos(tube);
        return glm::vec3{distance * std::sin(around), tube_radius * std::sin(tube), distance * std::cos(around)};
    });
}

TriangleMesh joined(TriangleMesh first, TriangleMesh const& second) {
    auto const offset = static_cast<unsigned>(first.positions.size());
    first.positions.insert(first.positions.end(), second.positions.begin(), second.positions.end());
    first.normals.insert(first.normals.end(), second.normals.begin(), second.normals.end());
    first.uvs.insert(first.uvs.end(), second.uvs.begin(), second.uvs.end());
    for (auto const& triangle : second.triangles) first.triangles.push_back(triangle + offset);
    return first;
}

TriangleMesh moved(TriangleMesh mesh, glm::vec3 offset) {
    for (auto& position : mesh.positions) position += offset;
    return mesh;
}

} // namespace quell::tracer
