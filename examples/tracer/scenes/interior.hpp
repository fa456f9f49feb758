#pragma once

#include "../scene.hpp"

namespace quell::tracer {

/// A closed room, so that indirect light has somewhere to go: y runs from 0 to size.y, x and z lie around `centre`. Numbers are those of
/// materials.
struct Interior {
    glm::vec3 centre{0.f}, size{5, 3, 5};
    int floor = 0, ceiling = 0, back = 0, front = 0, left = 0, right = 0;
};

/// `repeats`: how often a texture lies along one unit of length.
void add_interior(SceneDescription& scene, Interior const& room, float repeats = 0.5f);

} // namespace quell::tracer
