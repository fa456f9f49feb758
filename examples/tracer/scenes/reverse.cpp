#include "parts.hpp"

namespace quell::tracer {
namespace {

/// To and fro between -1 and 1 in so many frames; amid the shutter of the event's frame, which stays open for half of it, it turns.
float swing(float frame, float frames) { return shuttle((frame - event_frame - 0.25f) / frames + 0.25f); }

void add_yard(SceneDescription& scene) {
    int const ground = scene.paint(tiles({0.55f, 0.5f, 0.44f}, {0.3f, 0.28f, 0.26f}, 6));
    int const wall = scene.paint(bricks({0.56f, 0.36f, 0.28f}, {0.66f, 0.63f, 0.58f}, 12));
    scene.place(scene.add(rectangle(16, 10, {4, 2.5f})), ground, {.translation = {0, 0, 1}});
    scene.place(scene.add(rectangle(16, 8, {4, 2})), wall, {.translation = {0, 4, -2}, .rotation = upright});
    int const pole = scene.add(cylinder(0.05f, 0.05f, 3)), paint = scene.paint({0.8f, 0.78f, 0.7f});
    for (float x : {-3.f, -1.f, 1.2f, 3.1f}) scene.place(pole, paint, {.translation = {x, 0, -1.6f}});
}

} // namespace

/// A ball, a board on a hinge and a box, each of which turns back every few frames, while the shutter is open.
SceneDescription reverse() {
    SceneDescription scene;
    scene.secondary_rays = false;
    add_daylight(scene, {-0.5f, 0.8f, 1});
    add_yard(scene);
    int const checked = scene.paint(checker({0.8f, 0.15f, 0.1f}, {0.9f, 0.85f, 0.7f}, 6));
    int const blue = scene.paint(stripes({0.1f, 0.25f, 0.6f}, {0.6f, 0.75f, 0.85f}, 8));
    int const yellow = scene.paint(checker({0.85f, 0.7f, 0.1f}, {0.2f, 0.2f, 0.2f}, 4));
    scene.place(scene.add_sphere(), checked, [](float frame) {
        return Transform{{-1.7f + 0.9f * swing(frame, 8), 1.9f, 0.4f}, turn(0, {0, 1, 0}), glm::vec3{0.4f}}.matrix();
    });
    scene.place(scene.add(moved(box({0.22f, 1.5f, 0.1f}), {0, -0.75f, 0})), blue, [](float frame) {
        return Transform{{0.4f, 2.6f, 0.2f}, turn(50 * swing(frame, 6), {0, 0, 1})}.matrix();
    });
    scene.place(scene.add(box(glm::vec3{0.55f})), yellow, [](float frame) {
        return Transform{{2.1f, 1 + 0.7f * swing(frame, 10), 0.2f}, turn(20, {0, 1, 0})}.matrix();
    });
    scene.camera = [](float) { return look_at({0, 1.7f, 4.6f}, {0, 1.5f, -1}, 45); };
    return scene;
}

} // namespace quell::tracer
