#include "parts.hpp"

namespace quell::tracer {
namespace {

/// A pseudo-random number in [0, 1) for a fixed place.
float dice(int i) { return noise({static_cast<float>(i * 29 % 59) / 59, static_cast<float>(i * 13 % 47) / 47}, 64); }

/// A branch that hangs from the origin, with leaves on all sides.
TriangleMesh branch_mesh(int seed) {
    auto mesh = moved(cylinder(0.01f, 0.012f, 1.7f, 6), {0, -1.7f, 0});
    for (int i = 0; i < 34; ++i) {
        float const angle = 2.4f * static_cast<float>(i) + static_cast<float>(seed), out = 0.05f + 0.12f * dice(i + 40 * seed);
        auto leaf = box({0.11f, 0.15f, 0.004f});
        auto const rotation = turn(60 * dice(i + seed) - 30, {1, 0, 0.3f}) * turn(80 * dice(i + 3 * seed + 11) - 40, {0, 1, 0});
        for (auto& position : leaf.positions) position = rotation * position;
        for (auto& normal : leaf.normals) normal = rotation * normal;
        mesh =
            joined(std::move(mesh),
                   moved(std::move(leaf), {out * std::cos(angle), -0.05f * static_cast<float>(i) - 0.02f, 0.5f * out * std::sin(angle)}));
    }
    return mesh;
}

/// How far the curtain is open: not at all, then, fast at first, within four frames all the way.
float opening(float frame) {
    float const t = std::clamp((frame - event_frame + 1) / 4, 0.f, 1.f);
    return t * (2 - t);
}

/// Rows of branches that sway, until a gust blows them to both sides.
void add_curtain(SceneDescription& scene) {
    int const greens[]{scene.paint({0.16f, 0.4f, 0.1f}), scene.paint({0.32f, 0.5f, 0.12f}), scene.paint({0.5f, 0.42f, 0.1f})};
    int const branches[]{scene.add(branch_mesh(1)), scene.add(branch_mesh(2)), scene.add(branch_mesh(5))};
    for (int i = 0; i < 30; ++i) {
        float const x = -1.45f + 0.1f * static_cast<float>(i), phase = 6 * dice(i + 5), side = x < 0.05f ? -1.f : 1.f;
        float const z = 0.45f + 0.12f * static_cast<float>(i * 2 % 3);
        scene.place(branches[i % 3], greens[i * 2 % 3], [=](float frame) {
            float const sway = 3 * std::sin(0.35f * frame + phase), blown = 62 * opening(frame) * (0.8f + 0.2f * dice(i + 17));
            return Transform{{x, 2.35f, z}, turn(side * blown + sway, {0, 0, 1}) * turn(2 * sway, {0, 1, 0})}.matrix();
        });
    }
}

void add_shelf(SceneDescription& scene) {
    int const block = scene.add(box(glm::vec3{1}));
    for (int i = 0; i < 24; ++i) {
        float const hue = 7 * dice(i + 13), height = 0.3f + 0.3f * dice(i + 3);
        auto const wave = [hue](float offset) { return 0.12f + 0.3f * (1 + std::cos(hue + offset)); };
        int const paint = scene.paint({wave(0), wave(2.1f), wave(4.2f)});
        glm::vec3 const place{-1.5f + 0.42f * static_cast<float>(i % 8), 0.75f * static_cast<float>(i / 8) + height / 2, -1.3f};
        scene.place(block, paint, {.translation = place, .scale = {0.3f, height, 0.3f}});
    }
}

} // namespace

/// Leaves hang before a shelf, densely; all at once they open. Both lights shine at the ceiling: what the camera sees is lit indirectly,
/// but for a small lamp before the leaves.
SceneDescription leaves() {
    SceneDescription scene;
    int const floor = scene.paint(planks({0.55f, 0.4f, 0.26f}, 6));
    int const white = scene.paint(glm::vec3{0.86f}), back = scene.paint(stripes({0.7f, 0.62f, 0.5f}, {0.45f, 0.5f, 0.56f}, 5));
    int const orange = scene.paint({0.8f, 0.4f, 0.12f}), blue = scene.paint({0.15f, 0.35f, 0.7f});
    add_interior(scene, {{0, 0, 0.5f}, {4.4f, 2.8f, 4.4f}, floor, white, back, white, orange, blue});
    add_shelf(scene);
    add_curtain(scene);
    int const warm = scene.glow({60, 52, 42}), lamp = scene.glow({30, 26, 20});
    for (float side : {-1.f, 1.f}) scene.place(scene.add(rectangle(0.8f, 0.8f)), warm, {.translation = {side * 1.6f, 2, 1.4f}});
    scene.place(scene.add(rectangle(0.3f, 0.3f)), lamp,
                {.translation = {0.3f, 2.6f, 1.2f}, .rotation = facing(glm::vec3{-0.1f, -0.7f, -1})});
    scene.camera = [](float) { return look_at({0, 1.35f, 2.5f}, {0, 1.1f, -1.3f}, 50); };
    return scene;
}

} // namespace quell::tracer
