#include "revisit.hpp"

#include <glm/geometric.hpp>

namespace quell::tracer {
namespace {

/// Rays to a point end short of it, so that it doesn't hide itself. Its own position is only as exact as float placements are.
constexpr float part_of_the_way = 1 - 1e-3f;

} // namespace

Revisited revisit(PreparedScene const& scene, View const& view, Hit const& hit, float time) {
    auto const offset = scene.point(hit, time, When::now) - view.eye();
    float const distance = glm::length(offset);
    Revisited result{{view.eye(), offset / distance, distance, time}, hit, {}};
    result.hit.distance = distance;
    result.surface = surface_at(scene, result.ray, result.hit, view.pixel_angle());
    return result;
}

bool is_seen(PreparedScene const& scene, View const& view, Extent size, Revisited const& point) {
    auto const place = view.project(point.surface.position);
    bool const inside =
        place.x >= 0 && place.y >= 0 && place.x < static_cast<float>(size.width) && place.y < static_cast<float>(size.height);
    if (!inside) return false; // also where it is NaN: behind the camera
    auto ray = point.ray;
    ray.far *= part_of_the_way;
    return !scene.occluded(ray);
}

} // namespace quell::tracer
