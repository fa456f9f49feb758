#include "parts.hpp"

namespace quell::tracer {
namespace {

void add_furniture(SceneDescription& scene) {
    int const wood = scene.paint(planks({0.55f, 0.36f, 0.2f}, 6));
    int const green = scene.paint({0.2f, 0.5f, 0.25f}), grey = scene.paint(glm::vec3{0.6f});
    int const brass = scene.metal({0.95f, 0.78f, 0.45f}, 0.25f);
    scene.place(scene.add(box({1.3f, 0.1f, 0.8f})), wood, {.translation = {-0.6f, 0.75f, -1.1f}});
    for (float x : {-1.15f, -0.05f})
        for (float z : {-1.4f, -0.8f}) scene.place(scene.add(box({0.08f, 0.7f, 0.08f})), wood, {.translation = {x, 0.35f, z}});
    scene.place(scene.add_sphere(), brass, {.translation = {-0.4f, 1.05f, -1.1f}, .scale = glm::vec3{0.25f}});
    scene.place(scene.add(cylinder(0.3f, 0.3f, 1.4f)), green, {.translation = {1.4f, 0, -1.4f}});
    scene.place(scene.add(torus(0.3f, 0.1f)), grey, {.translation = {0.9f, 0.1f, -0.3f}});
}

} // namespace

/// A small lamp in a corner burns all the time; the large one overhead goes on. Nothing moves.
SceneDescription lightswitch() {
    SceneDescription scene;
    int const floor = scene.paint(tiles({0.6f, 0.55f, 0.45f}, {0.3f, 0.28f, 0.26f}, 4)),
              back = scene.paint(bricks({0.6f, 0.45f, 0.38f}, {0.7f, 0.68f, 0.62f}, 8));
    int const white = scene.paint(glm::vec3{0.8f}), red = scene.paint({0.7f, 0.2f, 0.15f});
    add_interior(scene, {{0, 0, 0}, {5, 2.8f, 5}, floor, white, back, white, red, white});
    add_furniture(scene);
    scene.place(scene.add_sphere(), scene.glow({32, 19, 9}), {.translation = {-2, 1.5f, -1.7f}, .scale = glm::vec3{0.16f}});
    Material const overhead{.emission = {30, 29, 27}, .brightness = [](float frame) { return frame < event_frame ? 0.f : 1.f; }};
    scene.place(scene.add(rectangle(1.2f, 0.8f)), scene.add(overhead), {.translation = {0.8f, 2.76f, 0}, .rotation = upside_down});
    scene.camera = [](float) { return look_at({0.3f, 1.5f, 2.2f}, {-0.1f, 0.9f, -1.5f}, 55); };
    return scene;
}

} // namespace quell::tracer
