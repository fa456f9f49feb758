#include "parts.hpp"

namespace quell::tracer {
namespace {

/// At 480x270 that is 13 pixels.
constexpr float degrees_per_frame = 2;

/// Shelves and pillars all around, no two alike, so that whatever is carried along from the image's border shows.
void add_surroundings(SceneDescription& scene) {
    int const block = scene.add(box(glm::vec3{1})), post = scene.add(cylinder(0.12f, 0.12f, 3)), ball = scene.add_sphere();
    for (int i = 0; i < 40; ++i) {
        auto const turns = static_cast<float>(i) / 40, hue = static_cast<float>(i * 17 % 40) / 40;
        auto const wave = [hue](float offset) { return 0.1f + 0.35f * (1 + std::cos(2 * pi * (hue + offset))); };
        int const paint = scene.paint({wave(0), wave(0.33f), wave(0.67f)});
        glm::vec3 const outward{std::sin(2 * pi * turns), 0, -std::cos(2 * pi * turns)};
        auto const rotation = turn(-360 * turns, {0, 1, 0});
        float const height = 0.4f + 0.9f * static_cast<float>(i * 7 % 11) / 11;
        scene.place(block, paint,
                    {.translation = outward * 2.9f + glm::vec3{0, height / 2, 0}, .rotation = rotation, .scale = {0.36f, height, 0.3f}});
        if (i % 4 == 1) scene.place(post, paint, {.translation = outward * 2.2f});
        if (i % 3 == 0) scene.place(ball, paint, {.translation = outward * 3.f + glm::vec3{0, height + 0.5f, 0}, .scale = glm::vec3{0.2f}});
    }
}

} // namespace

/// The camera stands still, then turns around at an even speed: at every frame a strip comes into the image that was never seen.
SceneDescription pan() {
    SceneDescription scene;
    int const floor = scene.paint(checker({0.7f, 0.66f, 0.6f}, {0.3f, 0.3f, 0.34f}, 4)), white = scene.paint(glm::vec3{0.85f});
    int const brick = scene.paint(bricks({0.6f, 0.4f, 0.32f}, {0.7f, 0.68f, 0.62f}, 8)),
              blue = scene.paint(stripes({0.3f, 0.4f, 0.6f}, {0.7f, 0.7f, 0.6f}, 6));
    add_interior(scene, {{0, 0, 0}, {7.2f, 3, 7.2f}, floor, white, brick, blue, blue, brick});
    add_surroundings(scene);
    int const panel = scene.glow({34, 31, 27});
    for (float side : {-1.f, 1.f})
        scene.place(scene.add(rectangle(0.8f, 0.8f)), panel, {.translation = {side * 1.3f, 2.96f, side * 0.6f}, .rotation = upside_down});
    scene.camera = [](float frame) {
        float const angle = degrees_per_frame * pi / 180 * std::max(0.f, frame - event_frame + 1);
        return look_at({0, 1.4f, 0}, {std::sin(angle), 1.25f, -std::cos(angle)}, 55);
    };
    return scene;
}

} // namespace quell::tracer
