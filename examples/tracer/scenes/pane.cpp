#include "parts.hpp"

namespace quell::tracer {
namespace {

/// What is seen through the panes.
void add_things(SceneDescription& scene) {
    int const ball = scene.add_sphere(), block = scene.add(box(glm::vec3{0.6f}));
    int const check = scene.paint(checker({0.8f, 0.7f, 0.2f}, {0.15f, 0.2f, 0.3f}, 4));
    int const red = scene.paint({0.7f, 0.15f, 0.1f}), white = scene.paint(glm::vec3{0.8f});
    for (int i = -2; i <= 2; ++i)
        scene.place(ball, i % 2 == 0 ? red : white,
                    {.translation = {0.8f * static_cast<float>(i), 0.35f, -4.2f}, .scale = glm::vec3{0.35f}});
    scene.place(block, check, [](float frame) {
        float const phase = 2 * pi * frame / 72;
        return Transform{{1.2f * std::sin(phase), 1.1f, -3.4f}, turn(2 * frame, {0, 1, 0})}.matrix();
    });
}

} // namespace

/// Two window panes, of which a fifth and a half reflects, before things that move: a sample of a pixel meets the pane or what is behind
/// it. One pane slides to and fro.
SceneDescription pane() {
    SceneDescription scene;
    int const floor = scene.paint(planks({0.5f, 0.3f, 0.16f}, 8)), white = scene.paint(glm::vec3{0.85f});
    int const brick = scene.paint(bricks({0.6f, 0.4f, 0.32f}, {0.7f, 0.68f, 0.62f}, 8)), blue = scene.paint({0.3f, 0.4f, 0.6f});
    add_interior(scene, {{0, 0, -2}, {7, 3, 7}, floor, white, brick, blue, blue, brick});
    add_things(scene);
    int const panel = scene.glow({30, 27, 23});
    scene.place(scene.add(rectangle(1.2f, 1.2f)), panel, {.translation = {0.4f, 2.96f, -1.4f}, .rotation = upside_down});
    int const sheet = scene.add(rectangle(1.5f, 1.6f));
    int const glass = scene.add(Material{.base = glm::vec3{0.9f}, .metallic = 1, .roughness = 0.1f, .coverage = {0.2f}});
    int const veil = scene.add(Material{.base = {0.75f, 0.8f, 0.7f}, .coverage = {0.5f}});
    scene.place(sheet, glass, {.translation = {-0.95f, 1.1f, -2.2f}, .rotation = upright});
    scene.place(sheet, veil, [](float frame) {
        return Transform{{0.95f + 0.35f * std::sin(2 * pi * frame / 48), 1.1f, -2.3f}, upright}.matrix();
    });
    scene.camera = [](float frame) {
        float const phase = 2 * pi * frame / 120;
        return look_at({0.3f * std::sin(phase), 1.2f, 1.1f}, {0, 1, -3}, 50);
    };
    return scene;
}

} // namespace quell::tracer
