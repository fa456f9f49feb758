#include "parts.hpp"

namespace quell::tracer {
namespace {

constexpr glm::vec3 eye{0, 1.8f, 0};

/// How far the camera has turned to the left.
float heading(float frame) { return 10.2f * frame + 8 * std::sin(frame / 11); }

/// A round square with houses, trees and stalls on all sides.
void add_square(SceneDescription& scene) {
    Town town{scene};
    int const paving = scene.paint(tiles({0.55f, 0.5f, 0.44f}, {0.3f, 0.27f, 0.24f}, 8));
    int const drum = scene.add(cylinder(0.4f, 0.4f, 1)), tent = scene.add(cylinder(1.1f, 0, 1.1f, 24)),
              post = scene.add(cylinder(0.06f, 0.06f, 2, 12));
    int const wood = scene.paint(planks({0.55f, 0.36f, 0.2f}, 6));
    int const awnings[]{scene.paint(stripes({0.8f, 0.12f, 0.08f}, {0.85f, 0.82f, 0.75f}, 8)),
                        scene.paint(stripes({0.1f, 0.3f, 0.65f}, {0.85f, 0.8f, 0.6f}, 8))};
    scene.place(scene.add(rectangle(60, 60, {10, 10})), paving);
    for (int i = 0; i < 17; ++i) {
        float const degrees = 360.f / 17 * static_cast<float>(i);
        auto const at = [&](float more, float radius) { return turn(degrees + more, {0, 1, 0}) * glm::vec3{0, 0, -radius}; };
        town.add_house(at(0, 15), degrees, {4.8f, 4 + 0.6f * static_cast<float>(i * 5 % 7), 4}, i);
        if (i % 3 != 0) town.add_tree(at(9, 9.5f + static_cast<float>(i % 4)), 2.5f + 0.3f * static_cast<float>(i * 3 % 5));
        if (i % 3 == 1) {
            scene.place(drum, wood, {.translation = at(4, 6.5f)});
            scene.place(drum, wood, {.translation = at(-3, 7), .scale = {0.8f, 1.4f, 0.8f}});
        }
        if (i % 3 != 0) continue;
        scene.place(tent, awnings[i % 2], {.translation = at(5, 8) + glm::vec3{0, 2, 0}});
        for (float side : {-5.f, 5.f})
            for (float near : {-0.6f, 0.6f}) scene.place(post, wood, {.translation = at(5 + side, 8 + near)});
    }
}

Texture ball_paint() {
    return painted(512, 256, [](glm::vec2 uv) {
        auto const star = glm::abs(glm::fract(uv * glm::vec2{8, 4}) - 0.5f);
        if (star.x + star.y < 0.22f) return glm::vec3{0.92f, 0.85f, 0.3f};
        return (std::abs(uv.y - 0.5f) < 0.03f ? glm::vec3{0.85f} : glm::vec3{0.1f, 0.35f, 0.15f}) *
               (0.7f + 0.6f * fractal_noise(uv, 16, 4));
    });
}

/// They fly up and down before the camera, and turn with it: whatever the background does, they move across it.
void add_jugglery(SceneDescription& scene) {
    int const turntable = scene.add_node([](float frame) { return Transform{eye, turn(heading(frame), {0, 1, 0})}.matrix(); });
    int const painted_ball = scene.paint(ball_paint()), crate = scene.paint(checker({0.8f, 0.66f, 0.35f}, {0.3f, 0.12f, 0.1f}, 4));
    scene.place(
        scene.add_sphere(), painted_ball,
        [](float frame) {
            glm::vec3 const place{-0.55f, 1.85f * shuttle((frame - 32.4f) / 15.3f), -3.2f};
            return Transform{place, turn(3 * frame, {1, 0.4f, 0}), glm::vec3{0.42f}}.matrix();
        },
        turntable);
    scene.place(
        scene.add(box(glm::vec3{0.7f})), crate,
        [](float frame) {
            glm::vec3 const place{1.1f + 0.1f * std::sin(0.4f * frame), 2.3f * shuttle((frame - 27.5f) / 17.9f), -3.9f};
            return Transform{place, turn(25 + 2 * frame, {0.3f, 1, 0})}.matrix();
        },
        turntable);
}

} // namespace

SceneDescription mixed() {
    SceneDescription scene;
    scene.secondary_rays = false;
    add_daylight(scene, {0.5f, 1, 0.4f});
    add_square(scene);
    add_jugglery(scene);
    scene.camera = [](float frame) {
        auto const forward = turn(heading(frame), {0, 1, 0}) * glm::vec3{0, 0.03f, -1};
        return look_at(eye, eye + forward, 48);
    };
    return scene;
}

} // namespace quell::tracer
