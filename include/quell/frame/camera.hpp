#pragma once

#include <quell/core/error.hpp>
#include <quell/image/extent.hpp>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// A host's perspective camera. Column-major GLM matrices, column vectors: clip = projection * view * world.
/// View space looks down -z. Normalised device coordinates are in [-1, 1] with y up: image row 0 is y = +1.
/// Any range of depth will do, reversed or not, if the projection can be inverted.
struct Camera {
    glm::mat4 view{1.f};       ///< world space to view space
    glm::mat4 projection{1.f}; ///< view space to clip space, without jitter
    glm::vec2 jitter{0.f};     ///< offset of the samples from the pixels' centres, in pixels, y down

    /// World space to clip space, without jitter.
    [[nodiscard]] glm::mat4 clip_from_world() const { return projection * view; }
    /// Equal in every number.
    friend bool operator==(Camera const&, Camera const&) = default;
};

/// The camera of a host whose view space looks along +z, as those of Direct3D do. World space may be left-handed or right-handed.
/// @param view world space to view space, x to the right, y up, z forward
/// @param projection that view space to clip space, without jitter
/// @param jitter as Camera::jitter
[[nodiscard]] inline Camera camera_looking_along_z(glm::mat4 view, glm::mat4 projection, glm::vec2 jitter = {}) {
    for (int column = 0; column < 4; ++column) view[column][2] = -view[column][2];
    projection[2] = -projection[2];
    return {.view = view, .projection = projection, .jitter = jitter};
}

} // namespace quell::inline QUELL_INSTRUCTION_SET
