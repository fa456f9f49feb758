#include "mask_blur.hpp"
#include "effect_sweep.hpp"

#include <glm/geometric.hpp>

#include <algorithm>

namespace quell::tracer::detail {
namespace {

/// A sweep of 60 pixels has one of these times in each of its pixels.
constexpr int time_count = 64;
/// In pixels: what moves less than that isn't blurred.
constexpr float min_motion = 0.1f;

bool is_far(glm::vec2 a, glm::vec2 b) { return !(glm::distance(a, b) < min_motion); } // also behind the camera, where it is NaN

} // namespace

OpenShutter::OpenShutter(PreparedScene const& scene_, Extent size)
    : scene(scene_), opening{0, {scene.camera(0, When::now), size}}, middle{0.5f, {scene.camera(0.5f, When::now), size}},
      closing{1, {scene.camera(1, When::now), size}} {
    for (int i = 0; i < time_count; ++i) {
        float const time = (static_cast<float>(i) + 0.5f) / time_count;
        moments.push_back({time, {scene.camera(time, When::now), size}});
    }
}

bool OpenShutter::has_motion(glm::ivec2 pixel) const {
    return std::ranges::any_of(moments, [&](Moment const& moment) { return has_motion(moment, pixel); });
}

bool OpenShutter::has_motion(Moment const& moment, glm::ivec2 pixel) const {
    Ray const ray{moment.view.eye(), moment.view.direction(glm::vec2(pixel) + 0.5f), infinity, moment.time};
    auto const hit = scene.intersect(ray);
    auto const place = [&](Moment const& at) {
        return hit ? at.view.project(scene.point(hit, at.time, When::now)) : at.view.project(ray.direction, 0);
    };
    auto const begin = place(opening);
    // Also in the middle, for what comes back to where it was.
    return is_far(begin, place(middle)) || is_far(begin, place(closing)) || (hit && has_moving_effect(moment, ray, hit));
}

bool OpenShutter::has_moving_effect(Moment const& moment, Ray const& ray, Hit const& hit) const {
    if (!scene.description().secondary_rays) return false;
    RayCounts counts;
    PathContext const path{{glm::ivec2{0}, 0, 0}, moment.time, 1, &counts};
    auto const surface = surface_at(scene, ray, hit, moment.view.pixel_angle());
    auto const signals =
        trace_signals<Channels<SweepOf<Visibility>, SweepOf<Glossy>>>(scene, surface, -ray.direction, path, moment.view.pixel_angle());
    auto const moves = [&](auto const& place) {
        auto const way = place(ShutterMoment{scene, hit, closing.view, 1}) - place(ShutterMoment{scene, hit, opening.view, 0});
        return glm::length(way) >= min_motion;
    };
    return moves([&](auto const& at) { return shadow_place(at, signals, moment.time); }) ||
           moves([&](auto const& at) { return reflection_place(at, signals); });
}

} // namespace quell::tracer::detail
