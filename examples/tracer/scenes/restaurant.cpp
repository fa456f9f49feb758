#include "parts.hpp"

namespace quell::tracer {
namespace {

/// Closed, warm, and still; the wall behind the camera is patterned, as it is what the metal shows.
void add_walls(SceneDescription& scene) {
    int const dark = scene.paint(tiles({0.3f, 0.26f, 0.24f}, {0.2f, 0.18f, 0.17f}, 8)), cream = scene.paint({0.8f, 0.74f, 0.64f});
    int const striped = scene.paint(stripes({0.75f, 0.62f, 0.42f}, {0.3f, 0.1f, 0.08f}, 8));
    int const green = scene.paint(plaster({0.18f, 0.36f, 0.28f}));
    add_interior(scene, {{0, 0, 0}, {7, 3, 7}, dark, cream, green, striped, cream, cream, {1, 1}, {1, 1}, {1, 1}});
}

void add_flat_metal(SceneDescription& scene) {
    int const steel = scene.metal(glm::vec3{0.86f, 0.87f, 0.88f}, 0.2f), copper = scene.metal({0.93f, 0.6f, 0.44f}, 0.3f);
    int const brass = scene.metal({0.9f, 0.75f, 0.42f}, 0.15f), wood = scene.paint({0.25f, 0.14f, 0.08f});
    int const panel = scene.add(rectangle(1.9f, 1.7f));
    int const metals[]{copper, steel, brass};
    for (int i = 0; i < 3; ++i) {
        float const x = 2.02f * static_cast<float>(i - 1);
        scene.place(panel, metals[i], {.translation = {x, 1.75f, -3.44f}, .rotation = upright});
        scene.place(scene.add(box({2, 1.8f, 0.05f})), wood, {.translation = {x, 1.75f, -3.47f}});
    }
    // The bar's top.
    scene.place(scene.add(box({5, 0.06f, 1.5f})), scene.metal(glm::vec3{0.75f, 0.76f, 0.8f}, 0.22f), {.translation = {0, 0.72f, -1.6f}});
    scene.place(scene.add(box({4.8f, 0.7f, 1.3f})), wood, {.translation = {0, 0.35f, -1.6f}});
}

void add_curved_metal(SceneDescription& scene) {
    scene.place(scene.add(cylinder(0.45f, 0.45f, 0.95f, 128)), scene.metal(glm::vec3{0.9f}, 0.15f), {.translation = {-1.4f, 0.75f, -2}});
    scene.place(scene.add_sphere(), scene.metal({0.95f, 0.8f, 0.5f}, 0.2f),
                {.translation = {1.4f, 1.3f, -1.98f}, .scale = glm::vec3{0.55f}});
}

/// Two people pass each other behind the camera and show in the metal alone.
void add_waiters(SceneDescription& scene) {
    int const red = scene.paint({0.75f, 0.05f, 0.08f}), blue = scene.paint({0.08f, 0.12f, 0.5f}), skin = scene.paint({0.75f, 0.5f, 0.36f});
    int const body = scene.add(cylinder(0.34f, 0.42f, 1.5f)), head = scene.add_sphere();
    for (float side : {-1.f, 1.f}) {
        int const waiter = scene.add_node([side](float frame) {
            return Transform{{-0.9f + side * 0.1f * (frame - 26), 0, 2 + 0.4f * side}}.matrix();
        });
        scene.place(body, side < 0 ? red : blue, {}, waiter);
        scene.place(head, skin, {.translation = {0, 1.75f, 0}, .scale = glm::vec3{0.24f}}, waiter);
    }
}

/// What is on and above the bar slides along it, and shows both by itself and in the metal.
void add_moving(SceneDescription& scene) {
    int const tomato = scene.paint({0.85f, 0.1f, 0.05f}), lime = scene.paint({0.5f, 0.8f, 0.1f});
    int const blue = scene.paint(checker({0.1f, 0.25f, 0.75f}, {0.9f, 0.88f, 0.8f}, 4));
    auto const along = [](float reach, float period, glm::vec3 centre) {
        return [=](float frame) {
            return Transform{centre + glm::vec3{reach * std::sin(2 * pi * (frame - 26) / period), 0, 0}, turn(0, {0, 1, 0})}.matrix();
        };
    };
    scene.place(scene.add(box(glm::vec3{0.36f})), blue, along(1.7f, 120, {0, 0.93f, -1.02f}));
    int const ball = scene.add_sphere();
    auto const rolling = along(-0.9f, 90, {0, 0.97f, -1.45f});
    scene.place(ball, tomato, [=](float frame) { return rolling(frame) * Transform{.scale = glm::vec3{0.22f}}.matrix(); });
    auto const hanging = along(1.5f, 140, {0, 2.15f, -2.3f});
    scene.place(ball, lime, [=](float frame) { return hanging(frame) * Transform{.scale = glm::vec3{0.24f}}.matrix(); });
}

} // namespace

SceneDescription restaurant() {
    SceneDescription scene;
    add_walls(scene);
    add_flat_metal(scene);
    add_curved_metal(scene);
    add_moving(scene);
    add_waiters(scene);
    scene.place(scene.add(rectangle(6.6f, 6.6f)), scene.glow({2.7f, 2.4f, 2.05f}), {.translation = {0, 2.98f, 0}, .rotation = upside_down});
    scene.camera = [](float) { return look_at({-1, 1.95f, 1.1f}, {0.15f, 1.28f, -2.4f}, 50); };
    return scene;
}

} // namespace quell::tracer
