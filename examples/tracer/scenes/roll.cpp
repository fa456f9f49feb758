#include "parts.hpp"

namespace quell::tracer {
namespace {

void add_street(SceneDescription& scene) {
    Town town{scene};
    int const cobbles = scene.paint(bricks({0.42f, 0.4f, 0.38f}, {0.2f, 0.19f, 0.17f}, 16));
    int const kerb = scene.paint(tiles({0.6f, 0.57f, 0.52f}, {0.35f, 0.33f, 0.3f}, 4));
    scene.place(scene.add(rectangle(80, 90, {20, 22})), cobbles, {.translation = {0, 0, -25}});
    float const widths[]{5, 4, 6, 4.5f, 5.5f, 4.2f, 5};
    for (float side : {-1.f, 1.f}) {
        scene.place(scene.add(box({1.6f, 0.3f, 60}, 0.5f)), kerb, {.translation = {side * 4.2f, 0, -20}});
        float z = side > 0 ? 8.f : 7.f;
        for (int i = 0; i < 7; ++i) {
            float const width = widths[side > 0 ? i : 6 - i], height = 4.5f + static_cast<float>(i * 3 % 5) * 0.7f;
            town.add_house({side * 7.2f, 0, z - width / 2}, -90 * side, {width, height, 4.4f}, side > 0 ? i : i + 2);
            z -= width + 0.4f;
            if (i > 0) town.add_tree({side * 4.4f, 0.1f, z}, 2.4f + 0.2f * static_cast<float>(i * 5 % 4));
        }
    }
    town.add_house({0.6f, 0, -36}, 10, {5, 11, 5}, 2);
}

void add_things(SceneDescription& scene) {
    int const iron = scene.paint({0.08f, 0.1f, 0.1f}), glow = scene.paint({0.9f, 0.85f, 0.6f});
    int const wood = scene.paint(planks({0.6f, 0.4f, 0.22f}, 5));
    int const cloth = scene.paint(stripes({0.75f, 0.1f, 0.08f}, {0.85f, 0.82f, 0.75f}, 9));
    int const pole = scene.add(cylinder(0.07f, 0.04f, 3, 16)), ball = scene.add_sphere(), crate = scene.add(box(glm::vec3{0.8f}));
    for (float z : {1.5f, -7.f, -16.f})
        for (float side : {-1.f, 1.f}) {
            scene.place(pole, iron, {.translation = {side * 3.2f, 0, z + side}});
            scene.place(ball, glow, {.translation = {side * 3.2f, 3.1f, z + side}, .scale = glm::vec3{0.17f}});
        }
    // A stall of the market with its awning, and what is for sale.
    scene.place(scene.add(rectangle(2.6f, 1.6f)), cloth, {.translation = {1.5f, 2.3f, -3}, .rotation = turn(22, {1, 0, 0})});
    for (float x : {0.3f, 2.7f}) scene.place(pole, wood, {.translation = {x, 0, -3.5f}, .scale = {0.7f, 0.84f, 0.7f}});
    int const apple = scene.paint({0.7f, 0.12f, 0.05f}), pear = scene.paint({0.6f, 0.65f, 0.15f});
    for (int i = 0; i < 3; ++i) {
        float const x = 0.65f + 0.85f * static_cast<float>(i);
        scene.place(crate, wood, {.translation = {x, 0.4f, -3.1f}});
        for (int j = 0; j < 9; ++j) {
            glm::vec3 const offset{0.24f * static_cast<float>(j % 3 - 1), 0.85f, 0.24f * static_cast<float>(j / 3 - 1)};
            scene.place(ball, i == 1 ? pear : apple, {.translation = glm::vec3{x, 0, -3.1f} + offset, .scale = glm::vec3{0.13f}});
        }
    }
    scene.place(crate, wood, {.translation = {-1.9f, 0.4f, -0.6f}, .rotation = turn(24, {0, 1, 0})});
    scene.place(crate, wood, {.translation = {-2.1f, 1.1f, -0.7f}, .rotation = turn(-14, {0, 1, 0}), .scale = glm::vec3{0.75f}});
}

} // namespace

SceneDescription roll() {
    SceneDescription scene;
    scene.secondary_rays = false;
    add_daylight(scene, {-0.6f, 1, 0.5f});
    add_street(scene);
    add_things(scene);
    scene.camera = [](float frame) {
        float const angle = (15.6f * frame + 7 * std::sin(frame / 9)) * pi / 180;
        return look_at({0, 1.9f, 5}, {0, 2.1f, -10}, 55, {std::sin(angle), std::cos(angle), 0});
    };
    return scene;
}

} // namespace quell::tracer
