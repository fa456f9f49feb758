#pragma once

#include "core/camera.hpp"

#include <quell/frame/camera.hpp>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>

namespace quell::live {

/// A camera as quell has it.
inline quell::Camera matrices_of(Camera const& camera) {
    auto const vector = [](Vector a) { return glm::vec3(a.x, a.y, a.z); };
    auto const eye = vector(camera.eye);
    float const across = camera.half_width_at_1, up = camera.half_height_at_1;
    return {.view = glm::lookAt(eye, eye + vector(camera.forward), vector(camera.up)),
            .projection = glm::frustum(-across, across, -up, up, 1.f, 100.f)};
}

} // namespace quell::live
