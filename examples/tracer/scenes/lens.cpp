#include "parts.hpp"

namespace quell::tracer {
namespace {

/// Posts and balls in three rows, 1.6, 3 and 5.4 away: the middle one is in focus.
void add_rows(SceneDescription& scene) {
    int const post = scene.add(cylinder(0.07f, 0.07f, 1.5f)), ball = scene.add_sphere();
    int const stripe = scene.paint(stripes({0.8f, 0.75f, 0.6f}, {0.12f, 0.2f, 0.35f}, 6)), gold = scene.metal({1, 0.74f, 0.36f}, 0.3f);
    int row = 0;
    for (float const away : {1.6f, 3.f, 5.4f}) {
        for (int i = -2; i <= 2; ++i) {
            float const x = static_cast<float>(i) * 0.42f * away + 0.15f * static_cast<float>(row);
            glm::vec3 const base{0.2f + 0.3f * static_cast<float>(row), 0.55f - 0.1f * static_cast<float>(i), 0.3f};
            if ((i + row) % 2 == 0)
                scene.place(post, stripe, {.translation = {x, 0, -away}});
            else
                scene.place(ball, scene.paint(base), {.translation = {x, 0.6f, -away}, .scale = glm::vec3{0.25f}});
        }
        ++row;
    }
    // One thing crosses from the foreground to the background.
    scene.place(ball, gold, [](float frame) {
        float const phase = 2 * pi * frame / 80;
        return Transform{{0.9f * std::sin(phase), 1.1f, -3.2f + 1.9f * std::cos(phase)}, turn(0, {0, 1, 0}), glm::vec3{0.16f}}.matrix();
    });
}

} // namespace

/// A wide lens, focused on the middle of three rows, moves sideways: what is before and behind it is blurred, and each sample of a pixel
/// there sees another thing.
SceneDescription lens() {
    SceneDescription scene;
    int const floor = scene.paint(tiles({0.7f, 0.66f, 0.6f}, {0.25f, 0.25f, 0.28f}, 4)), white = scene.paint(glm::vec3{0.85f});
    int const brick = scene.paint(bricks({0.6f, 0.4f, 0.32f}, {0.7f, 0.68f, 0.62f}, 8)), green = scene.paint({0.3f, 0.5f, 0.35f});
    add_interior(scene, {{0, 0, -2.6f}, {9, 3, 9}, floor, white, brick, green, green, brick});
    add_rows(scene);
    int const panel = scene.glow({30, 27, 23});
    scene.place(scene.add(rectangle(1.4f, 1.4f)), panel, {.translation = {0.6f, 2.96f, -2.4f}, .rotation = upside_down});
    scene.camera = [](float frame) {
        float const x = 0.5f * std::sin(2 * pi * frame / 96);
        auto pose = look_at({x, 1.1f, 0}, {0.4f * x, 0.75f, -3}, 50);
        pose.lens = {.radius = 0.07f, .focus = 3};
        return pose;
    };
    return scene;
}

} // namespace quell::tracer
