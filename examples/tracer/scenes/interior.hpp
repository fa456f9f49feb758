#pragma once

#include "../scene.hpp"

namespace quell::tracer {

/// A closed room, so that indirect light has somewhere to go: y runs from 0 to size.y, x and z lie around `centre`. Numbers are those of
/// materials.
struct Interior {
    glm::vec3 centre{0.f}, size{5, 3, 5};
    int floor = 0, ceiling = 0, back = 0, front = 0, left = 0, right = 0;
    /// How often a texture lies on floor and ceiling, on back and front, on left and right.
    glm::vec2 ground = glm::vec2{size.x, size.z} * 0.5f, across = glm::vec2{size.x, size.y} * 0.5f,
              along = glm::vec2{size.z, size.y} * 0.5f;
};
void add_interior(SceneDescription& scene, Interior const& room);

} // namespace quell::tracer
