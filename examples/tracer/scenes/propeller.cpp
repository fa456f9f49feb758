#include "parts.hpp"

namespace quell::tracer {
namespace {

/// No multiple of the angle between two blades: 17 degrees are left from frame to frame.
constexpr float degrees_per_frame = 137;

void add_hangar(SceneDescription& scene) {
    int const sheets = scene.paint(stripes({0.16f, 0.2f, 0.21f}, {0.08f, 0.11f, 0.12f}, 24));
    int const concrete = scene.paint(tiles({0.24f, 0.23f, 0.21f}, {0.1f, 0.1f, 0.09f}, 4));
    int const steel = scene.paint({0.3f, 0.16f, 0.1f}), pane = scene.paint({0.3f, 0.42f, 0.52f});
    scene.place(scene.add(rectangle(20, 14, {4, 3})), concrete);
    scene.place(scene.add(rectangle(20, 8, {3, 1})), sheets, {.translation = {0, 4, -6}, .rotation = upright});
    int const block = scene.add(box(glm::vec3{1}));
    for (int i = -4; i <= 4; ++i) {
        float const x = 2.1f * static_cast<float>(i);
        scene.place(block, steel, {.translation = {x, 4, -5.9f}, .scale = {0.16f, 8, 0.2f}});
        for (float y : {3.f, 3.9f}) scene.place(block, pane, {.translation = {x + 1.05f, y, -5.95f}, .scale = {1.5f, 0.8f, 0.1f}});
    }
    scene.place(block, steel, {.translation = {0, 2.45f, -5.9f}, .scale = {20, 0.14f, 0.2f}});
}

void add_stores(SceneDescription& scene) {
    int const drum = scene.add(cylinder(0.36f, 0.36f, 1)), hoop = scene.add(torus(0.36f, 0.03f, 48, 8)),
              crate = scene.add(box(glm::vec3{0.9f}));
    int const red = scene.paint({0.65f, 0.1f, 0.06f}), blue = scene.paint({0.08f, 0.2f, 0.45f});
    int const wood = scene.paint(planks({0.6f, 0.42f, 0.24f}, 5));
    for (auto const& [x, z, paint] :
         {std::tuple{-3.9f, -4.6f, red}, {-3.1f, -4.9f, blue}, {-4.7f, -4.3f, blue}, {3.6f, -4.8f, red}, {4.4f, -4.4f, red}}) {
        scene.place(drum, paint, {.translation = {x, 0, z}});
        for (float y : {0.03f, 0.5f, 0.97f}) scene.place(hoop, paint, {.translation = {x, y, z}});
    }
    scene.place(crate, wood, {.translation = {2.5f, 0.45f, -4.7f}, .rotation = turn(12, {0, 1, 0})});
    scene.place(crate, wood, {.translation = {2.6f, 1.3f, -4.8f}, .rotation = turn(-20, {0, 1, 0}), .scale = glm::vec3{0.85f}});
    scene.place(crate, wood, {.translation = {-2.1f, 0.45f, -4.9f}, .rotation = turn(-8, {0, 1, 0})});
}

/// It points towards +z, with its propeller at the origin.
void add_aeroplane(SceneDescription& scene, int parent) {
    auto const along = upright;
    int const skin = scene.paint(stripes({0.06f, 0.1f, 0.24f}, {0.5f, 0.08f, 0.05f}, 4));
    int const cloth = scene.paint(planks({0.2f, 0.26f, 0.14f}, 10));
    int const tyre = scene.paint(glm::vec3{0.06f}), metal = scene.paint({0.45f, 0.46f, 0.48f});
    // The profile's heights run from the tail to the nose.
    int const hull = scene.add(
        turned({{0.12f, -5}, {0.35f, -3.6f}, {0.62f, -2}, {0.68f, -1}, {0.62f, -0.45f}, {0.5f, -0.2f}, {0.3f, -0.12f}, {0, -0.1f}}));
    scene.place(hull, skin, {.rotation = along}, parent);
    scene.place(scene.add(cylinder(0.17f, 0.02f, 0.34f)), metal, {.translation = {0, 0, -0.05f}, .rotation = along}, parent);
    int const plank = scene.add(box({8.4f, 0.13f, 1.2f}, 0.6f));
    for (float y : {-0.5f, 0.95f}) scene.place(plank, cloth, {.translation = {0, y, -1.3f}}, parent);
    int const strut = scene.add(cylinder(0.035f, 0.035f, 1.45f, 12));
    for (float x : {-3.2f, -1.9f, 1.9f, 3.2f})
        for (float z : {-0.95f, -1.65f}) scene.place(strut, metal, {.translation = {x, -0.5f, z}}, parent);
    for (float side : {-1.f, 1.f}) {
        scene.place(strut, metal,
                    {.translation = {side * 0.75f, -1.35f, -1}, .rotation = turn(side * 22, {0, 0, 1}), .scale = {1, 0.6f, 1}}, parent);
        scene.place(scene.add(torus(0.25f, 0.09f, 48, 16)), tyre,
                    {.translation = {side * 0.78f, -1.35f, -1}, .rotation = turn(90, {0, 0, 1})}, parent);
    }
}

Texture blade_paint(glm::vec3 tip) {
    return painted(128, 512, [=](glm::vec2 uv) {
        auto const wood = glm::vec3{0.85f, 0.6f, 0.26f} * (0.6f + 0.8f * fractal_noise({uv.x, glm::fract(uv.y * 2)}, 8, 4));
        if (uv.y > 0.82f) return tip;
        return uv.y > 0.76f || std::abs(uv.y - 0.45f) < 0.02f ? glm::vec3{0.1f, 0.05f, 0.04f} : wood;
    });
}

/// From its hub along +y, twisted, facing +z.
TriangleMesh blade_mesh() {
    return surface(32, 48, [](float u, float v) {
        float const width = 0.3f * std::sqrt(std::sin(pi * (0.12f + 0.87f * v))), around = 2 * pi * u, twist = 1.1f - 0.75f * v;
        float const x = width * std::cos(around), z = 0.12f * width * std::sin(around);
        return glm::vec3{x * std::cos(twist) - z * std::sin(twist), 0.1f + 1.55f * v, -x * std::sin(twist) - z * std::cos(twist)};
    });
}

/// Each blade has a tip of its own colour.
void add_propeller(SceneDescription& scene, int parent) {
    int const blade = scene.add(blade_mesh());
    int const hub = scene.add_node(
        [](float frame) {
            return Transform{{0, 0, 0.1f}, turn(degrees_per_frame * frame, {0, 0, 1})}.matrix();
        },
        parent);
    float degrees = 0;
    for (auto const tip : {glm::vec3{0.2f, 0.6f, 0.75f}, glm::vec3{0.85f, 0.12f, 0.06f}, glm::vec3{0.9f}}) {
        scene.place(blade, scene.paint(blade_paint(tip)), {.rotation = turn(degrees, {0, 0, 1})}, hub);
        degrees += 120;
    }
}

} // namespace

SceneDescription propeller() {
    SceneDescription scene;
    scene.secondary_rays = false;
    add_daylight(scene, {-0.7f, 1, 1.1f});
    add_hangar(scene);
    add_stores(scene);
    int const aeroplane = scene.add_node(fixed({.translation = {-0.15f, 1.7f, 0}, .rotation = turn(14, {0, 1, 0})}));
    add_aeroplane(scene, aeroplane);
    add_propeller(scene, aeroplane);
    scene.camera = [](float) { return look_at({0.4f, 1.9f, 4.9f}, {0, 1.75f, 0}, 42); };
    return scene;
}

} // namespace quell::tracer
