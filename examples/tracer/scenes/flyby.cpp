#include "parts.hpp"

namespace quell::tracer {
namespace {

/// Fields of many colours, so that whatever is dragged along shows.
Texture mosaic() {
    return painted(512, 512, [](glm::vec2 uv) {
        auto const place = uv * 16.f, inside = glm::fract(place);
        auto const cell = glm::floor(place);
        if (std::min(std::min(inside.x, 1 - inside.x), std::min(inside.y, 1 - inside.y)) < 0.05f) return glm::vec3{0.2f, 0.19f, 0.18f};
        float const hue = 6.3f * glm::fract(0.618f * cell.x + 0.371f * cell.y + 0.11f * cell.x * cell.y);
        glm::vec3 const colour{0.55f + 0.25f * std::cos(hue), 0.5f + 0.2f * std::cos(hue + 2), 0.45f + 0.25f * std::cos(hue + 4)};
        return colour * (0.8f + 0.4f * fractal_noise(uv, 32, 4));
    });
}

/// An upright mirror in a wooden frame, and a hedge behind it.
void add_mirror(SceneDescription& scene) {
    int const silver = scene.metal(glm::vec3{0.92f, 0.93f, 0.92f}, 0), wood = scene.paint(planks({0.5f, 0.3f, 0.16f}, 6));
    int const hedge = scene.paint(plaster({0.12f, 0.26f, 0.08f}));
    scene.place(scene.add(rectangle(5, 2)), silver, {.translation = {0.3f, 1.3f, -1.8f}, .rotation = upright});
    int const bar = scene.add(box(glm::vec3{1}));
    for (float y : {0.24f, 2.36f}) scene.place(bar, wood, {.translation = {0.3f, y, -1.8f}, .scale = {5.24f, 0.12f, 0.16f}});
    for (float x : {-2.26f, 2.86f}) scene.place(bar, wood, {.translation = {x, 1.2f, -1.8f}, .scale = {0.12f, 2.4f, 0.16f}});
    scene.place(bar, hedge, {.translation = {0, 0.8f, -4}, .scale = {18, 1.6f, 1}});
}

void add_things(SceneDescription& scene) {
    int const red = scene.paint({0.75f, 0.2f, 0.05f}), white = scene.paint(glm::vec3{0.85f});
    int const wood = scene.paint(planks({0.6f, 0.42f, 0.24f}, 5));
    int const cone = scene.add(cylinder(0.2f, 0.02f, 0.55f)), band = scene.add(cylinder(0.155f, 0.11f, 0.14f));
    for (auto const& place :
         {glm::vec3{-2.6f, 0, -0.9f}, {-0.9f, 0, -1.2f}, {1.2f, 0, -1.1f}, {3, 0, -0.6f}, {-1.7f, 0, 1.5f}, {1.9f, 0, 1.4f}}) {
        scene.place(cone, red, {.translation = place});
        scene.place(band, white, {.translation = place + glm::vec3{0, 0.2f, 0}});
    }
    scene.place(scene.add(box(glm::vec3{0.6f})), wood, {.translation = {-3.3f, 0.3f, -1.6f}, .rotation = turn(25, {0, 1, 0})});
}

Texture ball_paint(glm::vec3 first, glm::vec3 second) {
    return painted(512, 256, [=](glm::vec2 uv) {
        auto const worn = 0.75f + 0.5f * fractal_noise(uv, 16, 4);
        if (std::abs(uv.y - 0.5f) < 0.07f) return glm::vec3{0.9f, 0.85f, 0.7f} * worn;
        return (glm::fract(uv.x * 6) < 0.5f ? first : second) * worn;
    });
}

/// Low over the ground, to and fro, turning round outside the image. When one does, the other is in the middle.
void add_balls(SceneDescription& scene) {
    int const ball = scene.add_sphere(), orange = scene.paint(ball_paint({0.85f, 0.45f, 0.05f}, {0.08f, 0.12f, 0.3f}));
    int const green = scene.paint(ball_paint({0.1f, 0.5f, 0.15f}, {0.75f, 0.8f, 0.6f}));
    scene.place(ball, orange, [](float frame) {
        glm::vec3 const place{3.9f * shuttle((frame - 32.3f) / 14.1f), 0.62f + 0.06f * std::sin(0.37f * frame), 1};
        return Transform{place, turn(2 * frame, {0.3f, 1, 0}) * turn(50, {1, 0, 0.3f}), glm::vec3{0.4f}}.matrix();
    });
    scene.place(ball, green, [](float frame) {
        glm::vec3 const place{4.6f * shuttle((frame - 28.4f) / 15.3f), 0.75f, -0.3f};
        return Transform{place, turn(-2 * frame, {0, 1, 0.2f}) * turn(20, {1, 0, 1}), glm::vec3{0.36f}}.matrix();
    });
}

} // namespace

SceneDescription flyby() {
    SceneDescription scene;
    scene.indirect_rays = false;
    add_daylight(scene, {-0.75f, 1, 0.2f}, 0.4f);
    scene.place(scene.add(rectangle(18, 14, {4, 3.1f})), scene.paint(mosaic()));
    add_mirror(scene);
    add_things(scene);
    add_balls(scene);
    scene.camera = [](float) { return look_at({0, 2.7f, 5.2f}, {0, 0.8f, -0.5f}, 45); };
    return scene;
}

} // namespace quell::tracer
