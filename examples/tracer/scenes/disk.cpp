#include "parts.hpp"

namespace quell::tracer {
namespace {

void add_walls(SceneDescription& scene) {
    int const floor = scene.paint(checker({0.72f, 0.68f, 0.6f}, {0.35f, 0.32f, 0.3f}, 12)), white = scene.paint(glm::vec3{0.86f});
    int const back = scene.paint(stripes({0.78f, 0.7f, 0.56f}, {0.4f, 0.5f, 0.6f}, 14));
    int const orange = scene.paint({0.82f, 0.4f, 0.1f}), blue = scene.paint({0.12f, 0.34f, 0.72f});
    int const wide = scene.add(rectangle(5, 5)), wall = scene.add(rectangle(5, 3));
    scene.place(wide, floor);
    scene.place(wide, white, {.translation = {0, 3, 0}, .rotation = upside_down});
    scene.place(wall, back, {.translation = {0, 1.5f, -1.6f}, .rotation = upright});
    scene.place(wall, white, {.translation = {0, 1.5f, 2.5f}, .rotation = turn(180, {0, 1, 0}) * upright});
    scene.place(wall, orange, {.translation = {-2.5f, 1.5f, 0}, .rotation = turn(90, {0, 1, 0}) * upright});
    scene.place(wall, blue, {.translation = {2.5f, 1.5f, 0}, .rotation = turn(-90, {0, 1, 0}) * upright});
}

/// An animal with long ears, all of it ellipsoids.
void add_bunny(SceneDescription& scene) {
    int const fur = scene.paint({0.78f, 0.72f, 0.64f}), nose = scene.paint({0.7f, 0.3f, 0.3f});
    int const eye = scene.paint(glm::vec3{0.03f}), ball = scene.add_sphere();
    struct Part {
        int material;
        glm::vec3 centre, radii;
        float tilt = 0;
    };
    for (auto const& [material, centre, radii, tilt] :
         {Part{fur, {0.12f, 0.52f, 0}, {0.58f, 0.5f, 0.44f}, 12}, Part{fur, {-0.36f, 1.02f, 0.06f}, {0.34f, 0.31f, 0.3f}},
          Part{fur, {-0.32f, 1.56f, -0.05f}, {0.1f, 0.36f, 0.08f}, -12}, Part{fur, {-0.56f, 1.5f, 0.12f}, {0.1f, 0.34f, 0.08f}, 18},
          Part{fur, {-0.4f, 0.16f, 0.26f}, {0.3f, 0.14f, 0.13f}}, Part{fur, {0.3f, 0.16f, 0.32f}, {0.34f, 0.15f, 0.16f}},
          Part{fur, {0.42f, 0.4f, 0.26f}, {0.32f, 0.34f, 0.22f}}, Part{fur, {0.72f, 0.5f, -0.1f}, glm::vec3{0.17f}},
          Part{nose, {-0.63f, 0.98f, 0.22f}, {0.06f, 0.05f, 0.05f}}, Part{eye, {-0.46f, 1.1f, 0.32f}, glm::vec3{0.05f}}})
        scene.place(ball, material, {.translation = centre + glm::vec3{0, 0, -0.6f}, .rotation = turn(tilt, {0, 0, 1}), .scale = radii});
}

/// Both lights shine away from what the camera sees.
void add_lights(SceneDescription& scene) {
    int const warm = scene.glow({84, 72, 57}), dish = scene.add(rectangle(0.8f, 0.8f));
    int const shade = scene.paint({0.3f, 0.3f, 0.32f}), plate = scene.add(box({0.9f, 0.05f, 0.9f}));
    for (float side : {-1.f, 1.f}) {
        scene.place(dish, warm, {.translation = {side * 1.95f, 2.14f, 0.7f}});
        scene.place(plate, shade, {.translation = {side * 1.95f, 2.1f, 0.7f}});
    }
}

} // namespace

SceneDescription disk() {
    SceneDescription scene;
    add_walls(scene);
    add_bunny(scene);
    add_lights(scene);
    // Upright, facing the camera; it starts before the animal and leaves it to the right.
    int const painted = scene.paint(stripes({0.85f, 0.82f, 0.76f}, {0.12f, 0.1f, 0.1f}, 10));
    scene.place(scene.add(moved(cylinder(0.8f, 0.8f, 0.08f, 96), {0, -0.04f, 0})), painted, [](float frame) {
        return Transform{{0.35f + 0.05f * (frame - 24), 0.82f, 0.35f}, upright}.matrix();
    });
    scene.camera = [](float) { return look_at({0.05f, 1.3f, 2.3f}, {0, 0.85f, -0.6f}, 50); };
    return scene;
}

} // namespace quell::tracer
