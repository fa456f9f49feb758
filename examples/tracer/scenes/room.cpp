#include "../patterns.hpp"
#include "../shapes.hpp"
#include "scenes.hpp"

#include <cmath>
#include <numbers>

namespace quell::tracer {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

glm::quat turn(float degrees, glm::vec3 axis) { return glm::angleAxis(degrees * pi / 180, axis); }

/// 7 wide, 3 high, 7 deep, closed on all sides so that indirect light has somewhere to go.
void add_walls(SceneDescription& scene) {
    int const wide = scene.add(rectangle(7, 7)), upright = scene.add(rectangle(7, 3, {3, 1.3f}));
    int const floor = scene.add(Material{.metallic = 0.45f, .roughness = 0.22f, .base_texture = scene.add(planks({0.42f, 0.24f, 0.12f}, 8))});
    int const ceiling = scene.add(Material{.base = glm::vec3{0.8f}});
    int const back = scene.add(Material{.base_texture = scene.add(bricks({0.48f, 0.36f, 0.28f}, {0.55f, 0.52f, 0.47f}, 10))});
    int const left = scene.add(Material{.base_texture = scene.add(plaster({0.62f, 0.09f, 0.06f}))});
    int const right = scene.add(Material{.base_texture = scene.add(plaster({0.06f, 0.32f, 0.4f}))});
    int const front = scene.add(Material{.base = {0.6f, 0.55f, 0.4f}});
    scene.place(scene.add(rectangle(7, 7, {2, 2})), floor);
    scene.place(wide, ceiling, {.translation = {0, 3, 0}, .rotation = turn(180, {1, 0, 0})});
    scene.place(upright, back, {.translation = {0, 1.5f, -3.5f}, .rotation = turn(90, {1, 0, 0})});
    scene.place(upright, front, {.translation = {0, 1.5f, 3.5f}, .rotation = turn(180, {0, 1, 0}) * turn(90, {1, 0, 0})});
    scene.place(upright, left, {.translation = {-3.5f, 1.5f, 0}, .rotation = turn(90, {0, 1, 0}) * turn(90, {1, 0, 0})});
    scene.place(upright, right, {.translation = {3.5f, 1.5f, 0}, .rotation = turn(-90, {0, 1, 0}) * turn(90, {1, 0, 0})});
}

void add_lights(SceneDescription& scene) {
    int const panel = scene.add(Material{.emission = {17, 14.5f, 11}});
    scene.place(scene.add(rectangle(1.7f, 1)), panel, {.translation = {0.3f, 2.98f, -0.4f}, .rotation = turn(180, {1, 0, 0})});
    int const lamp = scene.add(Material{.emission = {15, 6.5f, 2}});
    scene.place(scene.add_sphere(), lamp, {.translation = {-2.35f, 1.33f, -2.3f}, .scale = glm::vec3{0.16f}});
}

TriangleMesh table_mesh() {
    auto mesh = moved(box({1.5f, 0.07f, 1}), {0, 0.785f, 0});
    for (float x : {-0.68f, 0.68f})
        for (float z : {-0.43f, 0.43f}) mesh = joined(std::move(mesh), moved(box({0.06f, 0.75f, 0.06f}), {x, 0.375f, z}));
    return mesh;
}

void add_furniture(SceneDescription& scene) {
    int const wood = scene.add(Material{.base_texture = scene.add(planks({0.6f, 0.4f, 0.2f}, 4))});
    int const china = scene.add(Material{.base = {0.75f, 0.78f, 0.82f}, .metallic = 0.25f, .roughness = 0.15f});
    int const gold = scene.add(Material{.base = {1, 0.72f, 0.33f}, .metallic = 1, .roughness = 0.25f});
    int const steel = scene.add(Material{.base = glm::vec3{0.85f}, .metallic = 1, .roughness = 0.06f});
    int const rubber = scene.add(Material{.base = {0.1f, 0.12f, 0.35f}});
    scene.place(scene.add(table_mesh()), wood, {.translation = {-2.2f, 0, -2.2f}, .rotation = turn(12, {0, 1, 0})});
    scene.place(scene.add(cylinder(0.14f, 0.05f, 0.34f)), gold, {.translation = {-2.35f, 0.82f, -2.3f}});
    int const vase = scene.add(turned({{0, 0}, {0.16f, 0}, {0.24f, 0.14f}, {0.27f, 0.3f}, {0.2f, 0.5f}, {0.1f, 0.66f}, {0.09f, 0.76f}, {0.15f, 0.84f}}));
    scene.place(vase, china, {.translation = {-1.75f, 0.82f, -2.15f}, .scale = glm::vec3{0.6f}});
    scene.place(scene.add_sphere(), steel, {.translation = {2, 0.5f, -1.7f}, .scale = glm::vec3{0.5f}});
    scene.place(scene.add(torus(0.42f, 0.16f)), rubber, {.translation = {1.1f, 0.16f, -2.6f}});
    scene.place(scene.add(cylinder(0.3f, 0, 0.9f)), gold, {.translation = {2.7f, 0, -2.8f}});
}

/// What moves: a crate slides to and fro under the light, a small one turns on top of it.
void add_crates(SceneDescription& scene) {
    int const crate = scene.add(Material{.base_texture = scene.add(checker({0.75f, 0.6f, 0.15f}, {0.12f, 0.14f, 0.16f}, 4))});
    int const toy = scene.add(Material{.base = {0.2f, 0.6f, 0.25f}});
    int const carriage = scene.add_node([](float frame) {
        float const phase = 2 * pi * frame / 96;
        return Transform{{1.35f * std::sin(phase), 0, 0.1f}, turn(25 * std::sin(phase), {0, 1, 0})}.matrix();
    });
    scene.place(scene.add(box(glm::vec3{0.8f})), crate, {.translation = {0, 0.4f, 0}}, carriage);
    auto const turning = [](float frame) { return Transform{{0, 1.02f, 0}, turn(6 * frame, {0, 1, 0}) * turn(35, {1, 0, 1})}.matrix(); };
    scene.place(scene.add(box(glm::vec3{0.3f})), toy, turning, carriage);
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
        return look_at({0.5f * std::sin(phase), 1.5f, 3.3f - 0.15f * std::sin(phase)}, {0.1f, 0.85f, -1}, 52);
    };
    return scene;
}

} // namespace quell::tracer
