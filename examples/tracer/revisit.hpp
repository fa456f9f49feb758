#pragma once

#include "surface.hpp"
#include "view.hpp"

namespace quell::tracer {

/// A point of a surface that was hit at some other frame, as it is at the frame where the scene stands, seen from that frame's camera.
struct Revisited {
    Ray ray; ///< from the eye to the point, and no further
    Hit hit;
    Surface surface;
};

[[nodiscard]] inline Revisited revisit(PreparedScene const& scene, View const& view, Hit const& hit, float time = 0) {
    auto const offset = scene.point(hit, time, When::now) - view.eye();
    float const distance = glm::length(offset);
    Revisited result{{view.eye(), offset / distance, distance, time}, hit, {}};
    result.hit.distance = distance;
    result.surface = surface_at(scene, result.ray, result.hit, view.pixel_angle());
    return result;
}

/// Whether the camera sees the point: inside the image, before the camera, and nothing in the way.
[[nodiscard]] inline bool is_seen(PreparedScene const& scene, View const& view, Extent size, Revisited const& point) {
    auto const place = view.project(point.surface.position);
    bool const inside =
        place.x >= 0 && place.y >= 0 && place.x < static_cast<float>(size.width) && place.y < static_cast<float>(size.height);
    if (!inside) return false; // also where it is NaN: behind the camera
    auto ray = point.ray;
    // It ends short of the point, so that it doesn't hide itself. Its own position is only as exact as float placements are.
    ray.far *= 1 - 1e-3f;
    return !scene.occluded(ray);
}

} // namespace quell::tracer
