#include "digest.hpp"
#include "prepared.hpp"

namespace quell::tracer {
namespace {

void add(Digest& digest, TriangleMesh const& mesh) {
    digest.add(mesh.positions);
    digest.add(mesh.normals);
    digest.add(mesh.uvs);
    digest.add(mesh.triangles);
}

void add(Digest& digest, Texture const& texture) {
    digest.add(static_cast<int>(texture.encoding));
    digest.add(static_cast<int>(texture.wrap_u));
    digest.add(static_cast<int>(texture.wrap_v));
    digest.add(texture.levels.empty() ? 0 : texture.levels[0].width);
    if (!texture.levels.empty()) digest.add(texture.levels[0].texels);
}

void add(Digest& digest, Material const& material) {
    for (auto const& colour : {material.base, material.emission}) digest.add(colour);
    for (float number : {material.metallic, material.roughness, material.alpha_cutoff}) digest.add(number);
    for (int number : {material.base_texture, material.metallic_roughness_texture, material.emission_texture}) digest.add(number);
    digest.add(material.emits_both_sides);
}

std::uint64_t hash_of(SceneDescription const& scene) {
    Digest digest;
    for (auto const& shape : scene.shapes) {
        digest.add(shape.is_sphere);
        add(digest, shape.mesh);
    }
    for (auto const& texture : scene.textures) add(digest, texture);
    for (auto const& material : scene.materials) add(digest, material);
    for (auto const& instance : scene.instances) digest.add(glm::ivec2{instance.shape, instance.material});
    digest.add(scene.background.below);
    digest.add(scene.background.above);
    // Only what differs from the rule counts, so that references of other scenes stay what they are.
    if (!scene.indirect_rays) digest.add(1);
    if (!scene.secondary_rays) digest.add(2);
    return digest.value();
}

} // namespace

/// What the functions of time give at this frame counts, not the functions themselves, which can't be compared.
std::uint64_t PreparedScene::content_hash() const {
    Digest digest;
    digest.add(hash_of(scene));
    digest.add(current_shutter);
    for (auto const& placement : placements) digest.add(placement.now);
    for (auto const& deformation : deformations)
        for (auto const& moment : deformation.now) add(digest, moment);
    digest.add(brightnesses);
    for (float time : {0.f, 0.25f, 0.5f, 0.75f, 1.f}) {
        auto const pose = camera(time, When::now);
        digest.add(pose.world_from_camera);
        digest.add(pose.vertical_field_of_view);
    }
    return digest.value();
}

} // namespace quell::tracer
