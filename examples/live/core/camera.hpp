#pragma once

#include "vector.hpp"

namespace quell::live {

/// A place on the screen, in pixels: (0, 0) is the top left corner, y grows down.
struct ScreenPoint {
    float x = 0, y = 0; ///< pixels
};

/// A perspective camera without a roll.
struct Camera {
    Vector eye{};                    ///< world space
    Vector forward{}, right{}, up{}; ///< unit vectors
    float width = 1, height = 1;     ///< of the picture, pixels
    float half_width_at_1 = 1;       ///< half of what is seen at distance 1, across
    float half_height_at_1 = 1;      ///< and from top to bottom

    /// The direction through a place on the screen. Its length along the view axis is 1: a distance along it is a depth.
    QUELL_LIVE Vector direction(ScreenPoint at) const {
        float const x = (2 * at.x / width - 1) * half_width_at_1, y = (1 - 2 * at.y / height) * half_height_at_1;
        return forward + right * x + up * y;
    }
    /// Where a point is seen, by its way from the eye; NaN behind the camera. A direction is a point infinitely far away.
    QUELL_LIVE ScreenPoint project(Vector from_eye) const {
        float const depth = dot(from_eye, forward);
        if (!(depth > 0)) return {NAN, NAN};
        float const x = dot(from_eye, right) / (depth * half_width_at_1), y = dot(from_eye, up) / (depth * half_height_at_1);
        return {(x + 1) * 0.5f * width, (1 - y) * 0.5f * height};
    }
};

/// Where a camera stands that turns about a target.
struct Orbit {
    Vector target{};          ///< what it looks at
    float yaw = 0, pitch = 0; ///< radians; 0: it looks along -z
    float distance = 3;       ///< from the target
    float view = 0.9f;        ///< radians seen from top to bottom
};

/// The direction from the target to the eye.
QUELL_LIVE Vector towards_eye(Orbit const& o) { return {sinf(o.yaw) * cosf(o.pitch), sinf(o.pitch), cosf(o.yaw) * cosf(o.pitch)}; }

QUELL_LIVE Camera camera_of(Orbit const& orbit, int width, int height) {
    Camera camera;
    auto const back = towards_eye(orbit);
    camera.eye = orbit.target + back * orbit.distance;
    camera.forward = -back;
    camera.right = normalized(cross(camera.forward, {0, 1, 0}));
    camera.up = cross(camera.right, camera.forward);
    camera.width = static_cast<float>(width), camera.height = static_cast<float>(height);
    camera.half_height_at_1 = tanf(orbit.view / 2);
    camera.half_width_at_1 = camera.half_height_at_1 * camera.width / camera.height;
    return camera;
}

} // namespace quell::live
