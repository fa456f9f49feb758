#include "parts.hpp"

namespace quell::tracer {
namespace {

/// A pseudo-random number in [0, 1) for a fixed place.
float dice(int i) { return noise({static_cast<float>(i * 37 % 61) / 61, static_cast<float>(i * 17 % 53) / 53}, 64); }

void add_walls(SceneDescription& scene) {
    int const floor = scene.paint(planks({0.5f, 0.33f, 0.2f}, 10)), white = scene.paint(glm::vec3{0.86f, 0.84f, 0.8f});
    int const wallpaper = scene.paint(stripes({0.35f, 0.5f, 0.42f}, {0.45f, 0.6f, 0.5f}, 12));
    int const red = scene.paint({0.75f, 0.16f, 0.08f}), blue = scene.paint({0.15f, 0.25f, 0.7f});
    add_interior(scene, {{0, 0, 0.5f}, {6, 3, 4}, floor, white, wallpaper, white, red, blue, {2, 1.4f}, {1, 1}, {1, 1}});
}

/// Both lights face the ceiling: what the camera sees is lit by what comes back from there.
void add_lights(SceneDescription& scene) {
    int const warm = scene.glow({75, 64, 50}), cool = scene.glow({30, 36, 48}), brass = scene.paint({0.5f, 0.36f, 0.16f});
    int const dish = scene.add(rectangle(0.9f, 0.9f)), holder = scene.add(box({1, 0.06f, 1})),
              pole = scene.add(cylinder(0.03f, 0.03f, 1.28f));
    for (float side : {-1.f, 1.f}) {
        scene.place(dish, side < 0 ? warm : cool, {.translation = {side * 2.2f, 1.34f, 1}});
        scene.place(holder, brass, {.translation = {side * 2.2f, 1.3f, 1}});
        scene.place(pole, brass, {.translation = {side * 2.2f, 0, 1}});
    }
}

void add_books(SceneDescription& scene, float floor, int first) {
    int const book = scene.add(box(glm::vec3{1}));
    float x = -1.7f;
    for (int i = first; x < 1.62f; ++i) {
        float const width = 0.05f + 0.07f * dice(i), height = 0.26f + 0.14f * dice(i + 7), hue = 7 * dice(i + 13) - 2.2f;
        auto const wave = [hue](float offset) { return 0.12f + 0.6f * std::pow(0.5f + 0.5f * std::cos(hue + offset), 2.f); };
        int const cover = scene.paint({wave(0), wave(2.1f), wave(4.2f)});
        if (dice(i + 29) > 0.1f)
            scene.place(book, cover, {.translation = {x + width / 2, floor + height / 2, -1.3f}, .scale = {width * 0.94f, height, 0.22f}});
        x += width;
    }
}

/// Full of edges and colours, so that whatever is smeared or mixed up shows.
void add_shelf(SceneDescription& scene) {
    int const wood = scene.paint({0.32f, 0.2f, 0.12f}), board = scene.add(box({3.6f, 0.05f, 0.34f})),
              post = scene.add(box({0.06f, 2.1f, 0.34f}));
    for (int level = 0; level < 5; ++level) {
        float const height = 0.12f + 0.48f * static_cast<float>(level);
        scene.place(board, wood, {.translation = {0, height, -1.32f}});
        if (level < 4) add_books(scene, height + 0.025f, 31 * level);
    }
    for (float x : {-1.78f, 0.f, 1.78f}) scene.place(post, wood, {.translation = {x, 1.05f, -1.32f}});
    int const clay = scene.paint({0.7f, 0.42f, 0.28f}), ball = scene.paint({0.85f, 0.7f, 0.1f});
    scene.place(scene.add(torus(0.14f, 0.06f)), clay, {.translation = {-0.9f, 2.25f, -1.3f}, .rotation = turn(80, {1, 0, 0.2f})});
    scene.place(scene.add_sphere(), ball, {.translation = {0.8f, 2.22f, -1.3f}, .scale = glm::vec3{0.16f}});
}

/// A bright box and two dark ones pass each other at different speeds.
void add_sliders(SceneDescription& scene) {
    int const bright = scene.paint({0.93f, 0.9f, 0.82f}), dark = scene.paint({0.05f, 0.06f, 0.09f});
    int const checked = scene.paint(checker({0.1f, 0.3f, 0.6f}, {0.8f, 0.8f, 0.75f}, 6));
    auto const sliding = [](float depth, float height, float reach, float period, float start) {
        return [=](float frame) {
            return Transform{{reach * std::sin(2 * pi * (frame - start) / period), height, depth}, turn(0, {0, 1, 0})}.matrix();
        };
    };
    scene.place(scene.add(box({0.6f, 1.25f, 0.4f})), bright, sliding(-0.35f, 0.625f, 1.7f, 110, 30));
    scene.place(scene.add(box({0.5f, 0.6f, 0.4f})), checked, sliding(0.25f, 0.3f, 1.5f, 90, 71));
    scene.place(scene.add(box({0.4f, 1.7f, 0.15f})), dark, sliding(-0.75f, 0.85f, 2.1f, 130, -41));
}

} // namespace

SceneDescription boxes() {
    SceneDescription scene;
    add_walls(scene);
    add_lights(scene);
    add_shelf(scene);
    add_sliders(scene);
    scene.camera = [](float) { return look_at({0.2f, 1.35f, 2.4f}, {0, 1.05f, -1.3f}, 50); };
    return scene;
}

} // namespace quell::tracer
