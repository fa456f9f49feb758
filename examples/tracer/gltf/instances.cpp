#include "parts.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace quell::tracer::gltf {
namespace {

std::vector<unsigned> corner_sequence(Model const& model, tinygltf::Primitive const& primitive, std::size_t vertex_count) {
    if (primitive.indices >= 0) return model.indices(primitive.indices);
    std::vector<unsigned> sequence(vertex_count);
    for (std::size_t i = 0; i < vertex_count; ++i) sequence[i] = static_cast<unsigned>(i);
    return sequence;
}

/// Lists, strips and fans of triangles; points and lines give none.
std::vector<glm::uvec3> triangles_of(std::vector<unsigned> const& c, int mode) {
    std::vector<glm::uvec3> triangles;
    if (mode == TINYGLTF_MODE_TRIANGLES || mode < 0)
        for (std::size_t i = 0; i + 2 < c.size(); i += 3) triangles.emplace_back(c[i], c[i + 1], c[i + 2]);
    if (mode == TINYGLTF_MODE_TRIANGLE_STRIP)
        for (std::size_t i = 0; i + 2 < c.size(); ++i) triangles.emplace_back(c[i], c[i + 1 + i % 2], c[i + 2 - i % 2]);
    if (mode == TINYGLTF_MODE_TRIANGLE_FAN)
        for (std::size_t i = 1; i + 1 < c.size(); ++i) triangles.emplace_back(c[0], c[i], c[i + 1]);
    return triangles;
}

int attribute(tinygltf::Primitive const& primitive, char const* name) {
    auto const found = primitive.attributes.find(name);
    return found == primitive.attributes.end() ? -1 : found->second;
}

TriangleMesh mesh_of(Model const& model, tinygltf::Primitive const& primitive) {
    TriangleMesh mesh;
    int const positions = attribute(primitive, "POSITION"), normals = attribute(primitive, "NORMAL"),
              uvs = attribute(primitive, "TEXCOORD_0");
    if (positions < 0) return mesh;
    mesh.positions = model.vectors<glm::vec3>(positions);
    if (normals >= 0) mesh.normals = model.vectors<glm::vec3>(normals);
    if (uvs >= 0) mesh.uvs = model.vectors<glm::vec2>(uvs);
    auto const count = mesh.positions.size();
    if ((!mesh.normals.empty() && mesh.normals.size() != count) || (!mesh.uvs.empty() && mesh.uvs.size() != count))
        throw model.error("a mesh has " + std::to_string(count) + " positions but another number of normals or texture coordinates");
    mesh.triangles = triangles_of(corner_sequence(model, primitive, count), primitive.mode);
    for (auto const& corners : mesh.triangles)
        if (std::max({corners.x, corners.y, corners.z}) >= count)
            throw model.error("a triangle refers to a vertex beyond the " + std::to_string(count) + " of its mesh");
    return mesh;
}

std::vector<glm::uvec4> joints_of(Model const& model, int accessor) {
    std::vector<glm::uvec4> joints;
    for (auto const& values : model.vectors<glm::vec4>(accessor))
        joints.emplace_back(model.index(values.x), model.index(values.y), model.index(values.z), model.index(values.w));
    return joints;
}

void check_skin(Model const& model, Skin const& skin, std::size_t vertex_count) {
    if (skin.vertex_joints.size() != vertex_count || skin.vertex_weights.size() != vertex_count ||
        skin.inverse_bind.size() != skin.joints.size())
        throw model.error("a skin doesn't have joints and weights for each vertex, or a matrix for each joint");
    for (auto const& joints : skin.vertex_joints)
        for (int i = 0; i < 4; ++i)
            if (joints[i] >= skin.joints.size())
                throw model.error("a vertex follows joint " + std::to_string(joints[i]) + " of " + std::to_string(skin.joints.size()));
}

Skin skin_of(Model const& model, int number, tinygltf::Primitive const& primitive, std::size_t vertex_count) {
    auto const& source = model.item(model.content.skins, number, "skin");
    int const joints = attribute(primitive, "JOINTS_0"), weights = attribute(primitive, "WEIGHTS_0");
    Skin skin;
    if (joints < 0 || weights < 0) return skin;
    skin.joints = source.joints;
    for (int joint : skin.joints) model.item(model.content.nodes, joint, "node");
    skin.vertex_joints = joints_of(model, joints);
    skin.vertex_weights = model.vectors<glm::vec4>(weights);
    skin.inverse_bind.assign(skin.joints.size(), glm::mat4{1.f});
    if (source.inverseBindMatrices >= 0) {
        auto const values = model.floats(source.inverseBindMatrices, 16);
        skin.inverse_bind.assign(values.size() / 16, glm::mat4{1.f});
        for (std::size_t i = 0; i < values.size(); ++i)
            skin.inverse_bind[i / 16][static_cast<int>(i % 16 / 4)][static_cast<int>(i % 4)] = values[i];
    }
    check_skin(model, skin, vertex_count);
    return skin;
}

/// Rigid meshes are shared by the nodes that show them.
class Instances {
public:
    Instances(Model const& model_, SceneDescription& scene_) : model(model_), scene(scene_) {}

    void add(int node_number) {
        auto const& node = model.item(model.content.nodes, node_number, "node");
        if (node.mesh >= 0) {
            auto const& mesh = model.item(model.content.meshes, node.mesh, "mesh");
            for (std::size_t i = 0; i < mesh.primitives.size(); ++i) add(node_number, node, mesh.primitives[i], {node.mesh, i});
        }
        for (int child : node.children) add(child);
    }

private:
    void add(int node_number, tinygltf::Node const& node, tinygltf::Primitive const& primitive, std::pair<int, std::size_t> key) {
        bool const skinned = node.skin >= 0 && attribute(primitive, "JOINTS_0") >= 0;
        auto const found = shapes.find(key);
        int const shape = !skinned && found != shapes.end() ? found->second : add_shape(node, primitive, skinned);
        if (!skinned) shapes[key] = shape;
        if (scene.shapes[static_cast<std::size_t>(shape)].mesh.triangles.empty()) return;
        if (primitive.material >= 0) model.item(model.content.materials, primitive.material, "material");
        int const material = primitive.material >= 0 ? primitive.material : static_cast<int>(model.content.materials.size());
        scene.instances.push_back({shape, material, skinned ? -1 : node_number});
    }

    int add_shape(tinygltf::Node const& node, tinygltf::Primitive const& primitive, bool skinned) {
        Shape shape;
        shape.mesh = mesh_of(model, primitive);
        if (skinned) shape.skin = skin_of(model, node.skin, primitive, shape.mesh.positions.size());
        return scene.add(std::move(shape));
    }

    Model const& model;
    SceneDescription& scene;
    std::map<std::pair<int, std::size_t>, int> shapes;
};

} // namespace

void add_instances(Model const& model, SceneDescription& scene) {
    Instances instances{model, scene};
    auto const& content = model.content;
    if (content.scenes.empty()) throw model.error("it holds no scene");
    for (int node : model.item(content.scenes, std::max(content.defaultScene, 0), "scene").nodes) instances.add(node);
    if (scene.instances.empty()) throw model.error("it holds no triangles", "export its meshes too");
}

} // namespace quell::tracer::gltf
