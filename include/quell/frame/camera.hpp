#pragma once

#include <quell/core/error.hpp>
#include <quell/image/extent.hpp>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

namespace quell {

/// A host's camera. Column-major GLM matrices, column vectors: clip = projection * view * world.
/// The view looks down -z; the projection, a perspective one, maps to normalised device coordinates in [-1, 1] with y up (image row 0 is
/// y = +1). Whether its depth range is [0, 1], [-1, 1] or reversed makes no difference, as long as the matrix can be inverted.
struct Camera {
    glm::mat4 view{1.f};
    glm::mat4 projection{1.f}; ///< without jitter
    glm::vec2 jitter{0.f};     ///< sub-pixel offset of the sample from the pixel's centre, in pixels, y down

    [[nodiscard]] glm::mat4 clip_from_world() const { return projection * view; }
    friend bool operator==(Camera const&, Camera const&) = default;
};

} // namespace quell
