#include "parts.hpp"

namespace quell::tracer {
namespace {

/// Units per frame: at 480x270 the shadows on the wall then move about 5 pixels from one frame to the next.
constexpr float speed = 0.045f;

/// Rods as thin as a pixel or two, and beads hardly larger, in a frame; unevenly spaced, so that no shift maps it onto itself.
TriangleMesh harp_mesh() {
    TriangleMesh mesh = joined(moved(box({12, 0.03f, 0.03f}), {0, 0.06f, 0}), moved(box({12, 0.03f, 0.03f}), {0, 1.3f, 0}));
    float x = -5.9f;
    for (int i = 0; x < 5.9f; ++i) {
        float const radius = 0.008f + 0.003f * static_cast<float>(i * 3 % 4);
        mesh = joined(std::move(mesh), moved(cylinder(radius, radius, 1.26f, 8), {x, 0.05f, 0}));
        auto const bead = turned({{0, -0.03f}, {0.022f, -0.02f}, {0.03f, 0}, {0.022f, 0.02f}, {0, 0.03f}}, 10);
        mesh = joined(std::move(mesh), moved(bead, {x + 0.07f, 0.25f + 0.13f * static_cast<float>(i * 5 % 8), 0}));
        x += 0.17f + 0.1f * static_cast<float>(i * 4 % 7) / 7;
    }
    return mesh;
}

} // namespace

/// Rods and beads pass a small light; their shadows cross a pale wall and floor.
SceneDescription thinshadows() {
    SceneDescription scene;
    int const floor = scene.paint(tiles({0.72f, 0.68f, 0.6f}, {0.6f, 0.56f, 0.5f}, 4)), wall = scene.paint(plaster({0.76f, 0.74f, 0.7f}));
    scene.place(scene.add(rectangle(12, 8, {4, 2.7f})), floor, {.translation = {0, 0, 2}});
    scene.place(scene.add(rectangle(12, 5, {4, 1.7f})), wall, {.translation = {0, 2.5f, -1.6f}, .rotation = upright});
    scene.place(scene.add_sphere(), scene.paint({0.7f, 0.4f, 0.2f}), {.translation = {-1.1f, 0.35f, -0.9f}, .scale = glm::vec3{0.35f}});
    scene.place(scene.add(box({0.7f, 0.5f, 0.5f})), scene.paint({0.3f, 0.45f, 0.6f}),
                {.translation = {0.9f, 0.25f, -0.9f}, .rotation = turn(20, {0, 1, 0})});
    int const iron = scene.paint(glm::vec3{0.3f});
    scene.place(scene.add(harp_mesh()), iron, [](float frame) { return Transform{{speed * (frame - event_frame), 0, 0.3f}}.matrix(); });
    glm::vec3 const place{0.4f, 1.5f, 3.6f};
    scene.place(scene.add(rectangle(0.06f, 0.06f)), scene.glow({18000, 16800, 15000}),
                {.translation = place, .rotation = facing(glm::vec3{0, 0.6f, -1.2f} - place)});
    scene.background = {{0.04f, 0.04f, 0.05f}, {0.1f, 0.12f, 0.15f}};
    scene.camera = [](float) { return look_at({0, 2, 3.4f}, {0, 0.6f, -0.9f}, 42); };
    return scene;
}

} // namespace quell::tracer
