#include "parts.hpp"

namespace quell::tracer {
namespace {

void add_walls(SceneDescription& scene) {
    int const parquet = scene.add(planks({0.5f, 0.28f, 0.14f}, 8));
    int const floor = scene.add(Material{.metallic = 0.5f, .roughness = 0.2f, .base_texture = parquet});
    int const ceiling = scene.paint(glm::vec3{0.85f}), back = scene.paint(bricks({0.62f, 0.5f, 0.4f}, {0.66f, 0.63f, 0.58f}, 10));
    int const left = scene.paint(plaster({0.72f, 0.1f, 0.07f})), right = scene.paint(plaster({0.1f, 0.42f, 0.5f}));
    int const front = scene.paint({0.7f, 0.65f, 0.5f});
    add_interior(scene, {{0, 0, 0}, {5.2f, 2.7f, 6}, floor, ceiling, back, front, left, right, {1.6f, 2}, {2.6f, 1.3f}, {3, 1.3f}});
}

void add_lights(SceneDescription& scene) {
    int const panel = scene.glow({26, 23, 19});
    scene.place(scene.add(rectangle(1.5f, 0.9f)), panel, {.translation = {0.5f, 2.68f, 0.1f}, .rotation = upside_down});
    int const lamp = scene.glow({9, 4.4f, 1.7f});
    scene.place(scene.add_sphere(), lamp, {.translation = {-1.85f, 1.32f, -2.05f}, .scale = glm::vec3{0.17f}});
}

TriangleMesh table_mesh() {
    auto mesh = moved(box({1.3f, 0.06f, 0.8f}), {0, 0.75f, 0});
    for (float x : {-0.59f, 0.59f})
        for (float z : {-0.34f, 0.34f}) mesh = joined(std::move(mesh), moved(box({0.05f, 0.72f, 0.05f}), {x, 0.36f, z}));
    return mesh;
}

TriangleMesh vase_mesh() {
    std::vector<glm::vec2> profile;
    for (int i = 0; i <= 32; ++i) {
        float const t = static_cast<float>(i) / 32;
        profile.emplace_back(0.05f + 0.13f * std::sin(pi * std::pow(t, 0.6f)) * (1 - 0.3f * t) + 0.03f * std::pow(t, 5.f), 0.55f * t);
    }
    return turned(profile);
}

void add_furniture(SceneDescription& scene) {
    int const wood = scene.paint(planks({0.66f, 0.44f, 0.22f}, 4));
    int const china = scene.add(Material{.base = {0.75f, 0.8f, 0.88f}, .metallic = 0.25f, .roughness = 0.15f});
    int const gold = scene.metal({1, 0.74f, 0.36f}, 0.3f), steel = scene.metal(glm::vec3{0.88f}, 0.05f);
    int const rubber = scene.paint({0.12f, 0.15f, 0.5f}), shelf = scene.paint({0.3f, 0.2f, 0.13f});
    scene.place(scene.add(table_mesh()), wood, {.translation = {-1.7f, 0, -2}, .rotation = turn(8, {0, 1, 0})});
    scene.place(scene.add(cylinder(0.13f, 0.04f, 0.37f)), gold, {.translation = {-1.85f, 0.78f, -2.05f}});
    scene.place(scene.add(vase_mesh()), china, {.translation = {-1.3f, 0.78f, -1.9f}});
    scene.place(scene.add_sphere(), steel, {.translation = {-1.75f, 0.38f, -0.55f}, .scale = glm::vec3{0.38f}});
    scene.place(scene.add(torus(0.34f, 0.13f)), rubber, {.translation = {0.55f, 0.13f, -2.3f}});
    scene.place(scene.add(cylinder(0.24f, 0, 0.75f)), gold, {.translation = {2.15f, 0, -2.4f}});
    scene.place(scene.add(box({1.6f, 0.05f, 0.3f})), shelf, {.translation = {1.1f, 1.55f, -2.84f}});
    for (int i = 0; i < 9; ++i) {
        float const shade = static_cast<float>(i * 37 % 10) / 10, height = 0.26f + 0.1f * static_cast<float>(i * 53 % 7) / 7;
        int const cover = scene.paint({0.15f + 0.6f * shade, 0.5f - 0.4f * shade, 0.2f + 0.3f * std::abs(shade - 0.5f)});
        glm::vec3 const place{0.45f + 0.11f * static_cast<float>(i), 1.575f + height / 2, -2.84f};
        scene.place(scene.add(box({0.08f, height, 0.22f})), cover,
                    {.translation = place, .rotation = turn(i == 8 ? 14.f : 0.f, {0, 0, 1})});
    }
}

/// What moves: a crate slides to and fro under the light, a small block turns on top of it.
void add_crates(SceneDescription& scene) {
    int const crate = scene.paint(checker({0.85f, 0.68f, 0.2f}, {0.14f, 0.16f, 0.2f}, 4)), toy = scene.paint({0.25f, 0.7f, 0.3f});
    int const carriage = scene.add_node([](float frame) {
        float const phase = 2 * pi * (frame - 14) / 96;
        return Transform{{1.15f * std::sin(phase), 0, -0.35f}, turn(20 + 25 * std::sin(phase), {0, 1, 0})}.matrix();
    });
    scene.place(scene.add(box(glm::vec3{0.7f})), crate, {.translation = {0, 0.35f, 0}}, carriage);
    auto const turning = [](float frame) { return Transform{{0, 0.93f, 0}, turn(6 * frame, {0, 1, 0}) * turn(35, {1, 0, 1})}.matrix(); };
    scene.place(scene.add(box(glm::vec3{0.28f})), toy, turning, carriage);
}

} // namespace

SceneDescription room() {
    SceneDescription scene;
    add_walls(scene);
    add_lights(scene);
    add_furniture(scene);
    add_crates(scene);
    scene.camera = [](float frame) {
        float const phase = 2 * pi * frame / 120;
        return look_at({0.4f * std::sin(phase), 1.35f + 0.1f * std::sin(2 * phase), 2.75f}, {0, 0.85f, -1.2f}, 50);
    };
    return scene;
}

} // namespace quell::tracer
