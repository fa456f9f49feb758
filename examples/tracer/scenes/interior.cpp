#include "interior.hpp"

#include "../shapes.hpp"
#include "turn.hpp"

namespace quell::tracer {

void add_interior(SceneDescription& scene, Interior const& room) {
    auto const half = room.size * 0.5f;
    auto const place = [&](int shape, int material, glm::vec3 where, glm::quat const& rotation) {
        scene.place(shape, material, {.translation = room.centre + where, .rotation = rotation});
    };
    int const ground = scene.add(rectangle(room.size.x, room.size.z, room.ground));
    int const across = scene.add(rectangle(room.size.x, room.size.y, room.across));
    int const along = scene.add(rectangle(room.size.z, room.size.y, room.along));
    place(ground, room.floor, {0, 0, 0}, turn(0, {0, 1, 0}));
    place(ground, room.ceiling, {0, room.size.y, 0}, upside_down);
    place(across, room.back, {0, half.y, -half.z}, upright);
    place(across, room.front, {0, half.y, half.z}, turn(180, {0, 1, 0}) * upright);
    place(along, room.left, {-half.x, half.y, 0}, turn(90, {0, 1, 0}) * upright);
    place(along, room.right, {half.x, half.y, 0}, turn(-90, {0, 1, 0}) * upright);
}

} // namespace quell::tracer
