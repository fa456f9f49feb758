#include "parts.hpp"

namespace quell::tracer {
namespace {

/// The side of a house: bricks, windows, posters and boxes with flowers. Nothing of it moves.
void add_wall(SceneDescription& scene) {
    int const wall = scene.paint(bricks({0.6f, 0.34f, 0.24f}, {0.68f, 0.64f, 0.58f}, 12));
    int const paint = scene.paint({0.86f, 0.85f, 0.8f}), glass = scene.paint({0.06f, 0.09f, 0.13f});
    int const shutter = scene.paint(stripes({0.1f, 0.32f, 0.24f}, {0.06f, 0.2f, 0.15f}, 16));
    int const poster = scene.paint(checker({0.85f, 0.8f, 0.3f}, {0.2f, 0.2f, 0.25f}, 5));
    int const stone = scene.paint(marble({0.75f, 0.72f, 0.66f}, {0.45f, 0.4f, 0.36f}));
    scene.place(scene.add(rectangle(16, 9, {4, 2.25f})), wall, {.translation = {0, 3, -2}, .rotation = upright});
    int const board = scene.add(box(glm::vec3{1})), sheet = scene.add(rectangle(1, 1));
    scene.place(board, stone, {.translation = {0, 1, -1.9f}, .scale = {16, 0.3f, 0.3f}});
    for (float x : {-3.9f, -0.4f, 3.3f}) {
        scene.place(board, paint, {.translation = {x, 3.6f, -1.96f}, .scale = {1.5f, 2.1f, 0.12f}});
        for (float side : {-1.f, 1.f}) {
            for (float y : {3.1f, 4.1f})
                scene.place(board, glass, {.translation = {x + side * 0.34f, y, -1.92f}, .scale = {0.58f, 0.9f, 0.1f}});
            scene.place(
                sheet, shutter,
                {.translation = {x + side * 1.1f, 3.6f, -1.93f}, .rotation = upright * turn(90, {0, 1, 0}), .scale = {2.1f, 1, 0.6f}});
        }
        scene.place(board, stone, {.translation = {x, 2.5f, -1.85f}, .scale = {1.8f, 0.12f, 0.34f}});
    }
    scene.place(sheet, poster, {.translation = {1.6f, 2.3f, -1.97f}, .rotation = upright * turn(4, {0, 1, 0}), .scale = {1.1f, 1, 1.4f}});
    scene.place(sheet, stone, {.translation = {-2.2f, 1.9f, -1.97f}, .rotation = upright, .scale = {1.2f, 1, 0.8f}});
}

void add_flowers(SceneDescription& scene) {
    int const ball = scene.add_sphere(), leaf = scene.paint({0.16f, 0.36f, 0.1f});
    int const colours[]{scene.paint({0.8f, 0.12f, 0.2f}), scene.paint({0.9f, 0.75f, 0.2f}), scene.paint({0.75f, 0.6f, 0.85f})};
    for (float x : {-3.9f, -0.4f, 3.3f})
        for (int i = 0; i < 9; ++i) {
            float const along = 0.19f * static_cast<float>(i - 4), lift = 0.05f * static_cast<float>(i * 4 % 5);
            scene.place(ball, leaf, {.translation = {x + along, 2.62f + lift / 2, -1.8f}, .scale = {0.15f, 0.12f, 0.13f}});
            scene.place(ball, colours[i % 3], {.translation = {x + along + 0.04f, 2.74f + lift, -1.74f}, .scale = glm::vec3{0.07f}});
        }
}

Texture panels(glm::vec3 first, glm::vec3 second, int around) {
    return painted(512, 256, [=](glm::vec2 uv) {
        auto const worn = [&](glm::vec3 colour) { return colour * (0.75f + 0.5f * fractal_noise(uv, 16, 4)); };
        if (uv.y < 0.12f || uv.y > 0.88f) return worn(glm::vec3{0.85f});
        if (std::abs(uv.y - 0.5f) < 0.04f) return glm::vec3{0.08f};
        return worn(glm::fract(uv.x * static_cast<float>(around)) < 0.5f ? first : second);
    });
}

/// Both fly out of the image at either side before they turn.
void add_balls(SceneDescription& scene) {
    int const ball = scene.add_sphere(), red = scene.paint(panels({0.8f, 0.08f, 0.05f}, {0.9f, 0.8f, 0.6f}, 6));
    int const blue = scene.paint(panels({0.06f, 0.16f, 0.7f}, {0.25f, 0.7f, 0.8f}, 5));
    scene.place(ball, red, [](float frame) {
        glm::vec3 const place{4.1f * shuttle((frame - 32.6f) / 16.7f), 3.1f + 0.12f * std::sin(0.31f * frame), 1.5f};
        return Transform{place, turn(2 * frame, {0.2f, 1, 0.3f}) * turn(60, {1, 0, 0.4f}), glm::vec3{0.55f}}.matrix();
    });
    scene.place(ball, blue, [](float frame) {
        auto const place = glm::vec3{0.3f, 3, 1} + glm::vec3{0.9f, 2.6f, 0} * shuttle((frame - 32.9f) / 10.3f);
        return Transform{place, turn(-1.5f * frame, {1, 0.3f, 0}) * turn(35, {0, 0, 1}), glm::vec3{0.6f}}.matrix();
    });
}

} // namespace

SceneDescription spheres() {
    SceneDescription scene;
    scene.secondary_rays = false;
    add_daylight(scene, {-0.5f, 0.8f, 1});
    add_wall(scene);
    add_flowers(scene);
    add_balls(scene);
    scene.camera = [](float) { return look_at({0, 3, 6}, {0, 3, 0}, 45); };
    return scene;
}

} // namespace quell::tracer
