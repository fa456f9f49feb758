#include "parts.hpp"

namespace quell::tracer {
namespace {

/// Units per frame: at 480x270 the shadows on the wall then move about 12 pixels from one frame to the next.
constexpr float speed = 0.12f;

TriangleMesh picket_mesh(float height) {
    auto tip = cylinder(0.106f, 0, 0.16f, 4);
    for (auto& position : tip.positions) {
        // A pyramid on a square, turned so that its sides lie along the board, and as thin as the board is.
        position = turn(45, {0, 1, 0}) * position;
        position.z *= 0.04f / 0.15f;
        position.y += height + 0.1f;
    }
    compute_normals(tip);
    return joined(moved(box({0.15f, height, 0.04f}), {0, height / 2 + 0.1f, 0}), tip);
}

/// Spaced and sized unevenly: a regular fence would look the same again after a shift by one picket, old shadows and all.
TriangleMesh fence_mesh() {
    TriangleMesh mesh = joined(moved(box({17, 0.09f, 0.03f}), {0, 0.4f, 0.03f}), moved(box({17, 0.09f, 0.03f}), {0, 0.95f, 0.03f}));
    float x = -8.4f;
    for (int i = 0; x < 8.4f; ++i) {
        mesh = joined(std::move(mesh), moved(picket_mesh(1.05f + 0.2f * static_cast<float>(i * 5 % 7) / 7), {x, 0, 0}));
        x += 0.36f + 0.2f * static_cast<float>(i * 4 % 9) / 9;
    }
    return mesh;
}

void add_yard(SceneDescription& scene) {
    int const ground = scene.paint(tiles({0.6f, 0.55f, 0.47f}, {0.4f, 0.37f, 0.33f}, 6));
    int const wall = scene.paint(bricks({0.72f, 0.6f, 0.5f}, {0.78f, 0.75f, 0.7f}, 10));
    scene.place(scene.add(rectangle(14, 9.4f, {3.5f, 2.35f})), ground, {.translation = {0, 0, 2}});
    scene.place(scene.add(rectangle(14, 6, {5.6f, 2.4f})), wall, {.translation = {0, 3, -2.6f}, .rotation = upright});
    int const clay = scene.paint({0.66f, 0.34f, 0.2f}), leaf = scene.paint({0.2f, 0.42f, 0.14f});
    int const paint = scene.paint({0.2f, 0.4f, 0.62f}), straw = scene.paint({0.8f, 0.66f, 0.3f});
    int const pot = scene.add(turned({{0, 0}, {0.2f, 0}, {0.3f, 0.42f}, {0.34f, 0.42f}, {0.34f, 0.5f}, {0.28f, 0.5f}, {0, 0.45f}}));
    for (float x : {-2.2f, 1.75f}) {
        scene.place(pot, clay, {.translation = {x, 0, -1.4f}});
        scene.place(scene.add_sphere(), leaf, {.translation = {x, 0.78f, -1.4f}, .scale = {0.42f, 0.4f, 0.42f}});
    }
    scene.place(scene.add_sphere(), straw, {.translation = {-0.75f, 0.3f, -0.9f}, .scale = glm::vec3{0.3f}});
    scene.place(scene.add(box({0.9f, 0.7f, 0.5f})), paint, {.translation = {0.5f, 0.35f, -1.5f}, .rotation = turn(20, {0, 1, 0})});
}

/// The fence passes from left to right before the lights, which stand behind the camera.
SceneDescription yard_with_fence() {
    SceneDescription scene;
    add_yard(scene);
    // Dark, as it stands nearer to the lights than all else.
    int const wood = scene.paint({0.36f, 0.34f, 0.31f});
    scene.place(scene.add(fence_mesh()), wood, [](float frame) { return Transform{{speed * (frame - 26), 0, 1.4f}}.matrix(); });
    scene.background = {{0.03f, 0.03f, 0.04f}, {0.1f, 0.12f, 0.16f}};
    scene.camera = [](float) { return look_at({0, 2.9f, 4.7f}, {0, 0.62f, -0.9f}, 42); };
    return scene;
}

} // namespace

SceneDescription fence() {
    auto scene = yard_with_fence();
    glm::vec3 const place{0.6f, 1.2f, 4.7f};
    scene.place(scene.add(rectangle(0.24f, 0.24f)), scene.glow({2600, 2350, 1950}),
                {.translation = place, .rotation = facing(glm::vec3{0, 0.6f, -2} - place)});
    return scene;
}

SceneDescription fence_with_lights() {
    auto scene = yard_with_fence();
    int const panel = scene.add(rectangle(0.2f, 0.2f));
    glm::vec3 const colours[]{{3400, 450, 250}, {300, 2200, 400}, {450, 650, 3800}};
    for (int i = 0; i < 3; ++i) {
        auto const side = static_cast<float>(i - 1);
        // Different speeds and directions: no two of the shadows on one spot move alike.
        scene.place(panel, scene.glow(colours[i]), [side](float frame) {
            float const phase = 2 * pi * (frame - 26) / (90 + 20 * side) + side;
            glm::vec3 const place{1.6f * side - 0.8f * std::sin(phase), 1.2f + 0.25f * std::cos(phase), 5};
            return Transform{place, facing(glm::vec3{0, 0.6f, -2} - place)}.matrix();
        });
    }
    return scene;
}

} // namespace quell::tracer
