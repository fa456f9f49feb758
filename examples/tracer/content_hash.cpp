#include "digest.hpp"
#include "prepared.hpp"

#include <array>
#include <string>

namespace quell::tracer {
namespace {

template <class Value> inline constexpr bool is_plain = std::is_arithmetic_v<Value> || std::is_enum_v<Value>;
template <int n, class Number, glm::qualifier q> inline constexpr bool is_plain<glm::vec<n, Number, q>> = true;
template <int n, int m, class Number, glm::qualifier q> inline constexpr bool is_plain<glm::mat<n, m, Number, q>> = true;

/// A digest of whatever a scene is made of. What this doesn't know how to add doesn't compile.
class SceneDigest {
public:
    /// Functions of time count by what they give at these moments: they themselves can't be compared.
    explicit SceneDigest(std::vector<float> moments_) : moments(std::move(moments_)) { add(moments); }

    template <class Value>
        requires is_plain<Value>
    void add(Value const& value) { digest.add(value); }
    void add(std::string const& text) { digest.add(text); }
    template <class Value> void add(std::vector<Value> const& values) {
        if constexpr (is_plain<Value>) return digest.add(values);
        digest.add(values.size());
        for (auto const& value : values) add(value);
    }
    // A member that is not named here does not compile.
    void add(TriangleMesh const& mesh) {
        auto const& [positions, normals, uvs, triangles] = mesh;
        add_all(positions, normals, uvs, triangles);
    }
    void add(Skin const& skin) {
        auto const& [joints, inverse_bind, vertex_joints, vertex_weights] = skin;
        add_all(joints, inverse_bind, vertex_joints, vertex_weights);
    }
    void add(Shape const& shape) {
        auto const& [mesh, deformation, skin, is_sphere] = shape;
        add_all(mesh, deformation, skin, is_sphere);
    }
    void add(Texture::Level const& level) {
        auto const& [width, height, texels] = level;
        add_all(width, height, texels);
    }
    void add(Texture const& texture) {
        auto const& [levels, encoding, wrap_u, wrap_v] = texture;
        add_all(levels, encoding, wrap_u, wrap_v);
    }
    void add(Material const& material) {
        auto const& [base, metallic, roughness, emission, brightness, both_sides, cutoff, texture, metallic_roughness, emitted, coverage] =
            material;
        add_all(base, metallic, roughness, emission, brightness, both_sides, cutoff, texture, metallic_roughness, emitted, coverage);
    }
    void add(Node const& node) {
        auto const& [parent, pose] = node;
        add_all(parent, pose);
    }
    void add(SceneInstance const& instance) {
        auto const& [shape, material, node] = instance;
        add_all(shape, material, node);
    }
    void add(Background const& background) {
        auto const& [below, above] = background;
        add_all(below, above);
    }
    void add(CameraPose const& pose) {
        auto const& [world_from_camera, vertical_field_of_view, lens] = pose;
        add_all(world_from_camera, vertical_field_of_view, lens);
    }
    void add(SceneDescription const& scene) {
        auto const& [name, shapes, textures, materials, nodes, instances, camera, background, indirect_rays, secondary_rays] = scene;
        add_all(name, shapes, textures, materials, nodes, instances, camera, background, indirect_rays, secondary_rays);
    }
    template <class Value> void add(std::function<Value(float)> const& over_time) {
        add(over_time != nullptr);
        for (float const moment : moments)
            if (over_time) add(over_time(moment));
    }
    // What a scene does without leaves its digest as it is: then what was rendered before there was such a thing still counts.
    void add(Lens const& lens) {
        if (lens) digest.add(std::array{lens.radius, lens.focus});
    }
    void add(Coverage const& coverage) {
        if (coverage) digest.add(coverage.part);
    }
    /// It needs a mesh: content_hash() adds the vertices that come of it.
    void add(Deformation const& deformation) { add(deformation != nullptr); }

    [[nodiscard]] std::uint64_t value() const { return digest.value(); }

private:
    void add_all(auto const&... members) { (add(members), ...); }

    Digest digest;
    std::vector<float> moments;
};

} // namespace

std::uint64_t PreparedScene::content_hash() const {
    SceneDigest digest{moments_before(0)};
    digest.add(scene);
    for (auto const& deformation : deformations) digest.add(deformation.now);
    return digest.value();
}

} // namespace quell::tracer
