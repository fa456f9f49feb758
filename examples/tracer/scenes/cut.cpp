#include "parts.hpp"

namespace quell::tracer {
namespace {

/// How far apart the two rooms are.
constexpr float apart = 20;

struct Look {
    glm::vec3 paint, stripe, light;
    float lamp_side; ///< where in the room the lamp hangs
};

/// Both rooms are alike in shape, so that depth and normals alone don't tell one from the other; light and paint do.
void add_room(SceneDescription& scene, float x, Look const& look) {
    int const floor = scene.paint(planks(look.stripe * 0.7f, 8)), wall = scene.paint(stripes(look.paint, look.stripe, 6));
    int const plain = scene.paint(look.paint), white = scene.paint(glm::vec3{0.85f});
    add_interior(scene, {{x, 0, 0}, {5, 2.8f, 5}, floor, white, wall, white, plain, plain});
    int const panel = scene.glow(look.light);
    scene.place(scene.add(rectangle(1, 0.8f)), panel, {.translation = {x + look.lamp_side, 2.76f, 0.2f}, .rotation = upside_down});
}

void add_furniture(SceneDescription& scene, float x, Look const& look) {
    int const wood = scene.paint(look.stripe), steel = scene.metal({0.9f, 0.88f, 0.84f}, 0.2f);
    int const block = scene.add(box({0.8f, 0.9f, 0.8f})), column = scene.add(cylinder(0.2f, 0.2f, 1.7f));
    float const side = look.lamp_side > 0 ? 1.f : -1.f;
    scene.place(block, wood, {.translation = {x - side * 1.1f, 0.45f, -1.2f}, .rotation = turn(side * 25, {0, 1, 0})});
    scene.place(column, wood, {.translation = {x + side * 1.4f, 0, -1.6f}});
    scene.place(scene.add_sphere(), steel, {.translation = {x + side * 0.35f, 0.4f, -0.7f}, .scale = glm::vec3{0.4f}});
}

} // namespace

SceneDescription cut() {
    SceneDescription scene;
    Look const first{{0.75f, 0.3f, 0.2f}, {0.85f, 0.75f, 0.5f}, {44, 34, 24}, 1},
        second{{0.2f, 0.35f, 0.6f}, {0.3f, 0.6f, 0.6f}, {16, 20, 26}, -1};
    for (auto const* look : {&first, &second}) {
        float const x = look == &first ? 0 : apart;
        add_room(scene, x, *look);
        add_furniture(scene, x, *look);
    }
    scene.camera = [](float frame) {
        float const x = frame < event_frame ? 0 : apart, drift = 0.3f * std::sin(frame / 20);
        return look_at({x + drift, 1.5f, 2.2f}, {x + drift / 2, 0.9f, -1.5f}, 55);
    };
    return scene;
}

} // namespace quell::tracer
