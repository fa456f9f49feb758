#include "parts.hpp"

namespace quell::tracer {
namespace {

void add_walls(SceneDescription& scene) {
    int const pink = scene.paint(plaster({0.82f, 0.42f, 0.46f})), cream = scene.paint({0.85f, 0.8f, 0.72f});
    int const floor = scene.paint(planks({0.62f, 0.46f, 0.32f}, 10));
    add_interior(scene, {{0, 0, 0}, {6, 2.8f, 6}, floor, cream, pink, cream, pink, pink, {1.6f, 1.6f}});
    int const rail = scene.add(box({6, 0.12f, 0.03f}));
    scene.place(rail, cream, {.translation = {0, 0.06f, -2.98f}});
    scene.place(rail, cream, {.translation = {0, 0.95f, -2.98f}, .scale = {1, 0.4f, 1}});
}

/// A plate on four thin legs.
TriangleMesh on_legs(glm::vec3 size, float leg) {
    auto mesh = moved(box({size.x, 0.05f, size.z}), {0, size.y - 0.025f, 0});
    for (float x : {-0.46f, 0.46f})
        for (float z : {-0.44f, 0.44f})
            mesh = joined(std::move(mesh), moved(box({leg, size.y - 0.05f, leg}), {x * size.x, size.y / 2 - 0.025f, z * size.z}));
    return mesh;
}

TriangleMesh chair_mesh() {
    auto mesh = on_legs({0.48f, 0.48f, 0.46f}, 0.035f);
    for (float x : {-0.21f, -0.07f, 0.07f, 0.21f}) mesh = joined(std::move(mesh), moved(box({0.03f, 0.55f, 0.03f}), {x, 0.75f, -0.21f}));
    return joined(std::move(mesh), moved(box({0.5f, 0.09f, 0.04f}), {0, 1.04f, -0.21f}));
}

TriangleMesh vase_mesh() {
    std::vector<glm::vec2> profile{{0, 0}};
    for (int i = 0; i <= 28; ++i) {
        float const t = static_cast<float>(i) / 28;
        profile.emplace_back(0.09f + 0.11f * std::sin(pi * std::pow(t, 0.7f)) + 0.05f * std::pow(t, 6.f), 0.6f * t);
    }
    return turned(profile);
}

void add_furniture(SceneDescription& scene) {
    int const walnut = scene.paint({0.28f, 0.16f, 0.09f}), white = scene.paint({0.82f, 0.8f, 0.77f});
    int const velvet = scene.paint({0.12f, 0.3f, 0.34f}), brass = scene.paint({0.7f, 0.5f, 0.2f}), chair = scene.add(chair_mesh());
    scene.place(scene.add(on_legs({1.5f, 0.74f, 0.8f}, 0.045f)), walnut,
                {.translation = {0.1f, 0, -0.9f}, .rotation = turn(-6, {0, 1, 0})});
    scene.place(chair, white, {.translation = {-1.35f, 0, -1.1f}, .rotation = turn(65, {0, 1, 0})});
    scene.place(chair, white, {.translation = {1.55f, 0, -1.3f}, .rotation = turn(-50, {0, 1, 0})});
    scene.place(scene.add(on_legs({0.5f, 0.55f, 0.5f}, 0.03f)), velvet, {.translation = {-2.2f, 0, -2.3f}});
    scene.place(scene.add_sphere(), brass, {.translation = {-2.2f, 0.72f, -2.3f}, .scale = glm::vec3{0.17f}});
    scene.place(scene.add(on_legs({1.1f, 0.85f, 0.36f}, 0.035f)), walnut, {.translation = {1.6f, 0, -2.6f}});
    scene.place(scene.add(torus(0.17f, 0.05f)), velvet, {.translation = {1.3f, 1.05f, -2.6f}, .rotation = turn(75, {1, 0.3f, 0})});
    scene.place(scene.add(box({0.3f, 0.4f, 0.03f})), brass, {.translation = {1.85f, 1.05f, -2.65f}, .rotation = turn(-10, {1, 0, 0})});
}

} // namespace

SceneDescription pinkroom() {
    SceneDescription scene;
    add_walls(scene);
    add_furniture(scene);
    int const china = scene.paint({0.75f, 0.82f, 0.88f});
    scene.place(scene.add(vase_mesh()), china, [](float frame) {
        return Transform{{0.1f + 0.55f * std::sin((frame - 26) / 16), 0.74f, -0.9f}}.matrix();
    });
    scene.place(scene.add(rectangle(0.6f, 0.6f)), scene.glow({120, 108, 92}), [](float frame) {
        float const phase = (frame - 26) / 15;
        glm::vec3 const place{1.8f * std::sin(phase), 2.1f, 1.1f + 0.3f * std::cos(phase)};
        return Transform{place, facing(glm::vec3{0, 0.3f, -1.4f} - place)}.matrix();
    });
    scene.camera = [](float) { return look_at({0.1f, 1.6f, 1.7f}, {0, 0.62f, -1.5f}, 52); };
    return scene;
}

} // namespace quell::tracer
