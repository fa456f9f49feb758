#include "worlds.hpp"

#include <functional>
#include <set>

using namespace quell;
using namespace quell::tracer;

namespace {

/// A skin that leaves a mesh as it is.
Skin still_skin(std::vector<int> const& joints, TriangleMesh const& mesh) {
    auto const vertices = mesh.positions.size();
    return {joints, {joints.size(), glm::mat4{1.f}}, {vertices, glm::uvec4{0}}, {vertices, glm::vec4{1, 0, 0, 0}}};
}

/// Something of everything, two of each thing that there are indices of.
SceneDescription all_sorts() {
    auto scene = world({0, 1, 4}, {0, 0, 0});
    for (auto const& texel : {glm::u8vec4{100, 100, 100, 255}, glm::u8vec4{200, 200, 200, 255}})
        scene.add(Texture{2, 2, std::vector(4, texel), Encoding::linear});
    for (int i = 0; i < 2; ++i) scene.add(Material{.base_texture = 0, .metallic_roughness_texture = 0, .emission_texture = 0});
    scene.place(scene.add(rectangle(1, 1)), 0, {.translation = {1, 0, 0}});
    scene.place(scene.add_sphere(), 1, {.translation = {-1, 0, 0}});
    Shape skinned;
    skinned.mesh = rectangle(1, 1);
    skinned.skin = still_skin({0, 1}, skinned.mesh);
    scene.place(scene.add(std::move(skinned)), 1);
    return scene;
}

std::uint64_t hash_of(SceneDescription scene, float frame = 3, float shutter = 0.5f, int keys = 3) {
    PreparedScene prepared{std::move(scene)};
    prepared.move_to(frame, shutter, keys);
    return prepared.content_hash();
}

} // namespace

TEST_CASE("every member of all that a scene is made of counts") {
    std::vector<std::function<void(SceneDescription&)>> changes;
    auto const change = [&](auto const& find, auto const&... of_members) {
        (changes.emplace_back([=](SceneDescription& scene) { of_members(find(scene)); }), ...);
    };
    change(
        [](auto& scene) -> auto& { return scene.materials[0]; }, [](Material& m) { m.base.x = 0.1f; },
        [](Material& m) { m.metallic = 0.5f; }, [](Material& m) { m.roughness = 0.5f; }, [](Material& m) { m.emission.y = 1; },
        [](Material& m) { m.brightness = [](float) { return 2.f; }; }, [](Material& m) { m.emits_both_sides = true; },
        [](Material& m) { m.alpha_cutoff = 0.5f; }, [](Material& m) { m.base_texture = 1; },
        [](Material& m) { m.metallic_roughness_texture = 1; }, [](Material& m) { m.emission_texture = 1; },
        [](Material& m) { m.coverage.part = 0.5f; });
    change(
        [](auto& scene) -> auto& { return scene.textures[0]; }, [](Texture& t) { t.levels.resize(1); },
        [](Texture& t) { t.encoding = Encoding::srgb; }, [](Texture& t) { t.wrap_u = Wrap::mirror; },
        [](Texture& t) { t.wrap_v = Wrap::mirror; });
    change(
        [](auto& scene) -> auto& { return scene.textures[0].levels[0]; }, [](Texture::Level& l) { l.width = 1; },
        [](Texture::Level& l) { l.height = 1; }, [](Texture::Level& l) { l.texels[3].g = 7; });
    change(
        [](auto& scene) -> auto& { return scene.shapes[0]; },
        [](Shape& s) {
            s.mesh = box({1, 1, 1});
        },
        [](Shape& s) { s.deformation = [](float, TriangleMesh& mesh) { mesh.positions[0].y = 1; }; },
        [](Shape& s) { s.skin = still_skin({0}, s.mesh); }, [](Shape& s) { s.is_sphere = true; });
    change(
        [](auto& scene) -> auto& { return scene.shapes[0].mesh; }, [](TriangleMesh& m) { m.positions[0].y = 0.1f; },
        [](TriangleMesh& m) {
            m.normals[0] = glm::vec3{1, 0, 0};
        },
        [](TriangleMesh& m) { m.uvs[0].x = 0.3f; }, [](TriangleMesh& m) { std::swap(m.triangles[0], m.triangles[1]); });
    change(
        [](auto& scene) -> auto& { return scene.shapes[2].skin; }, [](Skin& s) { s.joints[0] = 1; },
        [](Skin& s) { s.inverse_bind[1][3].x = 1; }, [](Skin& s) { s.vertex_joints[0].x = 1; },
        [](Skin& s) { s.vertex_weights[0].y = 0.5f; });
    change(
        [](auto& scene) -> auto& { return scene.nodes[1]; }, [](Node& n) { n.parent = 0; },
        [](Node& n) {
            n.pose = fixed({.translation = {0, 1, 0}});
        });
    change(
        [](auto& scene) -> auto& { return scene.instances[0]; }, [](SceneInstance& i) { i.shape = 1; },
        [](SceneInstance& i) { i.material = 1; }, [](SceneInstance& i) { i.node = 1; });
    change(
        [](auto& scene) -> auto& { return scene.background; }, [](Background& b) { b.below.x = 1; }, [](Background& b) { b.above.z = 1; });
    change(
        [](auto& scene) -> auto& { return scene; }, [](SceneDescription& s) { s.name = "another"; },
        [](SceneDescription& s) { s.add_sphere(); },
        [](SceneDescription& s) {
            s.add(Texture{1, 1, {glm::u8vec4{1}}});
        },
        [](SceneDescription& s) { s.add(Material{}); }, [](SceneDescription& s) { s.add_node(fixed({})); },
        [](SceneDescription& s) { s.instances.pop_back(); },
        [](SceneDescription& s) { s.camera = [](float) {
                                      return look_at({0, 2, 3}, {0, 0, 0}, 60);
                                  }; },
        [](SceneDescription& s) { s.indirect_rays = false; }, [](SceneDescription& s) { s.secondary_rays = false; });
    std::set<std::uint64_t> hashes{hash_of(all_sorts())};
    for (auto const& each : changes) {
        CAPTURE(hashes.size());
        auto scene = all_sorts();
        each(scene);
        CHECK(hashes.insert(hash_of(std::move(scene))).second);
    }
}

TEST_CASE("a camera counts, and its lens where it is open") {
    auto const hash_from = [](CameraPose const& pose) {
        auto scene = all_sorts();
        scene.camera = [=](float) { return pose; };
        return hash_of(std::move(scene));
    };
    auto const pose = look_at({0, 1, 4}, {0, 0, 0}, 60);
    auto const with_lens = [&](Lens lens) { return hash_from({pose.world_from_camera, pose.vertical_field_of_view, lens}); };
    CHECK(hash_from(pose) != hash_from({pose.world_from_camera, 0.5f}));
    CHECK(with_lens({0.1f, 2}) != hash_from(pose));
    CHECK(with_lens({0.1f, 2}) != with_lens({0.2f, 2}));
    CHECK(with_lens({0.1f, 2}) != with_lens({0.1f, 3}));
    CHECK(with_lens({0, 2}) == hash_from(pose)); // a pinhole sees all sharply
}

TEST_CASE("functions of time count by what they give while the shutter is open, and at each of its moments") {
    auto const switched_on_at = [](float when) {
        auto scene = all_sorts();
        scene.materials[0].brightness = [=](float frame) { return frame < when ? 0.f : 1.f; };
        return hash_of(std::move(scene));
    };
    CHECK(switched_on_at(10) == switched_on_at(11));
    CHECK(switched_on_at(1) == switched_on_at(2));
    CHECK(switched_on_at(2) != switched_on_at(10));
    auto const seen_from = [](float shutter, int keys) {
        auto scene = all_sorts();
        scene.camera = [](float frame) { return look_at({frame, 1, 4}, {0, 0, 0}, 60); };
        return hash_of(std::move(scene), 3, shutter, keys);
    };
    CHECK(seen_from(0.5f, 9) == seen_from(0.5f, 9));
    CHECK(seen_from(0.5f, 9) != seen_from(0.5f, 17)); // the one's moments are among the other's
    CHECK(seen_from(0.5f, 9) != seen_from(0.4f, 9));
    CHECK(seen_from(0.5f, 9) != seen_from(0, 9));
    CHECK(seen_from(0, 9) == seen_from(0, 17)); // one moment, whatever their number
}
