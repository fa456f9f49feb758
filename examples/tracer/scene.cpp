#include "scene.hpp"

#include <glm/ext/matrix_clip_space.hpp>

#include <utility>

namespace quell::tracer {
namespace {

template <class Item> int append(std::vector<Item>& items, Item item) {
    items.push_back(std::move(item));
    return static_cast<int>(items.size()) - 1;
}

} // namespace

int SceneDescription::add(Shape shape) { return append(shapes, std::move(shape)); }
int SceneDescription::add(Texture texture) { return append(textures, std::move(texture)); }
int SceneDescription::add(Material material) { return append(materials, material); }
int SceneDescription::add_node(Pose pose, int parent) { return append(nodes, Node{parent, std::move(pose)}); }

int SceneDescription::add(TriangleMesh mesh) {
    Shape shape;
    shape.mesh = std::move(mesh);
    return add(std::move(shape));
}

int SceneDescription::add_sphere() {
    Shape shape;
    shape.is_sphere = true;
    return add(std::move(shape));
}

int SceneDescription::place(int shape, int material, Transform const& transform, int parent) {
    return place(shape, material, fixed(transform), parent);
}

glm::mat4 node_matrix(std::vector<Node> const& nodes, int node, float frame) {
    glm::mat4 matrix{1.f};
    for (; node >= 0; node = nodes[static_cast<std::size_t>(node)].parent)
        matrix = nodes[static_cast<std::size_t>(node)].pose(frame) * matrix;
    return matrix;
}

glm::mat4 SceneDescription::node_matrix(int node, float frame) const { return tracer::node_matrix(nodes, node, frame); }

TriangleMesh SceneDescription::vertices_at(Shape const& shape, float frame) const {
    TriangleMesh mesh{shape.mesh.positions, shape.mesh.normals, {}, {}};
    if (shape.deformation) {
        mesh.triangles = shape.mesh.triangles;
        shape.deformation(frame, mesh);
    }
    if (shape.skin.joints.empty()) return mesh;
    std::vector<glm::mat4> joints;
    for (std::size_t i = 0; i < shape.skin.joints.size(); ++i)
        joints.push_back(node_matrix(shape.skin.joints[i], frame) * shape.skin.inverse_bind[i]);
    apply_skin(shape.skin, joints, mesh);
    return mesh;
}

Camera SceneDescription::camera_at(float frame, Extent size) const { return camera_from(camera(frame), size); }

// Every comparison is false for NaN.
bool CameraPose::is_usable() const {
    glm::mat3 axes{world_from_camera};
    for (int i = 0; i < 3; ++i) axes[i] = glm::normalize(axes[i]);
    auto const from_origin = glm::abs(glm::vec3(world_from_camera[3]));
    // Embree takes no origins beyond 1.8e18.
    bool const in_reach = from_origin.x < 1e15f && from_origin.y < 1e15f && from_origin.z < 1e15f;
    bool const looks_somewhere = std::abs(glm::determinant(axes)) > 1e-6f;
    bool const has_usable_lens = lens.radius >= 0 && lens.radius < 1e15f && lens.focus > 0 && lens.focus < 1e15f;
    return in_reach && looks_somewhere && has_usable_lens && vertical_field_of_view > 1e-6f && vertical_field_of_view < pi - 1e-6f;
}

CameraPose look_at(glm::vec3 eye, glm::vec3 target, float field_of_view, glm::vec3 up) {
    auto const forward = glm::normalize(target - eye);
    if (glm::length(glm::cross(forward, glm::normalize(up))) < 1e-5f) up = {0, 0, forward.y < 0 ? -1 : 1};
    return {glm::inverse(glm::lookAt(eye, target, up)), glm::radians(field_of_view)};
}

Camera camera_from(CameraPose const& pose, Extent size) {
    float const aspect = static_cast<float>(size.width) / static_cast<float>(size.height);
    Camera camera;
    camera.view = glm::inverse(pose.world_from_camera);
    camera.projection = glm::perspective(pose.vertical_field_of_view, aspect, 0.05f, 1000.f);
    return camera;
}

} // namespace quell::tracer
