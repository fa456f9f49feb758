#include "mask_tests.hpp"
#include "effect_sweep.hpp"

#include <algorithm>

namespace quell::tracer::detail {
namespace {

constexpr int shadow_samples = 32, lobe_samples = 16;
/// What fewer of the samples find is too faint to see.
constexpr int min_shadowed = 2, min_reflected = 2;
/// In pixels, per frame or while the shutter is open: what moves less than that, bilinear history follows well enough, and no blur shows.
constexpr float min_motion = 0.1f;
/// A sweep of 60 pixels has one of these times in each of its pixels.
constexpr int time_count = 64;
/// Stands for infinitely far away: the motion of its image is the camera's rotation.
constexpr float far_away = 1e4f;

/// The plane that touches the surface, now and where the point's object had it one frame ago.
struct TangentPlanes {
    Plane now, before;

    TangentPlanes(MaskPoint const& point, Surface const& surface)
        : now{surface.position, surface.normal}, before{point.scene.point(point.hit, 0, When::before), surface.normal} {
        auto const placement = point.scene.placement(point.hit.instance, 0, When::now);
        auto const placement_before = point.scene.placement(point.hit.instance, 0, When::before);
        if (placement == placement_before) return; // exactly the same, without rounding
        auto const motion = glm::mat3(placement_before) * glm::inverse(glm::mat3(placement));
        before.normal = glm::normalize(glm::transpose(glm::inverse(motion)) * surface.normal);
    }
};

/// How far apart two places in the image are; infinite where one of them isn't before the camera.
float apart(glm::vec2 a, glm::vec2 b) {
    float const distance = glm::distance(a, b);
    return distance >= 0 ? distance : infinity;
}

/// In pixels of the previous frame: where the shadow that falls on the point now was then, against where the point itself was.
float shadow_motion(MaskPoint const& point, TangentPlanes const& planes, Signals const& signals) {
    bool const stands_still = signals.light == signals.light_previous && signals.blocker == signals.blocker_previous &&
                              planes.now.point == planes.before.point && planes.now.normal == planes.before.normal;
    if (stands_still) return 0;
    auto const shadow = shadow_on(planes.before, signals.light_previous, signals.blocker_previous);
    // What moves as one, light, blocker and receiver, keeps its shadow where it is.
    if (glm::distance(shadow, planes.before.point) < 1e-4f * glm::distance(planes.now.point, signals.light)) return 0;
    return apart(point.view_before.project(shadow), point.view_before.project(planes.before.point));
}

/// In pixels: the motion of the virtual image of what is reflected, less the motion of the reflector.
float reflection_motion(MaskPoint const& point, TangentPlanes const& planes, Signals const& signals, glm::vec3 mirror_direction) {
    bool const is_miss = !(glm::length(signals.glossy_hit) >= 0);
    auto const now = is_miss ? planes.now.point + far_away * mirror_direction : signals.glossy_hit;
    auto const before = is_miss ? now : signals.glossy_hit_previous;
    auto const image = point.view_before.project(planes.before.mirrored(before)) - point.view.project(planes.now.mirrored(now));
    return apart(image, point.view_before.project(planes.before.point) - point.view.project(planes.now.point));
}

/// The same stratified samples in all pixels: masks have clean edges then instead of noisy ones.
SampleKey key_of(int sample) { return {glm::ivec2{0}, static_cast<std::uint32_t>(sample), 0}; }

bool is_far(glm::vec2 a, glm::vec2 b) { return !(glm::distance(a, b) < min_motion); } // also behind the camera, where it is NaN

} // namespace

bool has_moving_shadow(MaskPoint const& point) {
    auto const surface = revisit(point.scene, point.view, point.hit).surface;
    if (surface.is_emitter) return false;
    TangentPlanes const planes{point, surface};
    RayCounts counts;
    for (int i = 0, shadowed = 0; i < shadow_samples; ++i) {
        PathContext const path{key_of(i), 0, &counts};
        Signals signals;
        auto const light = sample_lighting(point.scene, surface, 0, sample_pair(path.key, SampleUse::light_point),
                                           sample_pair(path.key, SampleUse::light_choice).x)
                               .sample;
        if (!light.exists) return false;
        signals.light = light.position;
        signals.light_previous = light.position_before;
        trace_shadow(point.scene, surface, path, true, signals);
        if (signals.visibility > 0 || shadow_motion(point, planes, signals) < min_motion) continue;
        if (++shadowed == min_shadowed) return true;
    }
    return false;
}

bool has_moving_reflection(MaskPoint const& point) {
    auto const seen = revisit(point.scene, point.view, point.hit);
    if (seen.surface.is_emitter || !(seen.surface.metallic > 0)) return false;
    TangentPlanes const planes{point, seen.surface};
    RayCounts counts;
    for (int i = 0, reflected = 0; i < lobe_samples; ++i) {
        PathContext const path{key_of(i), 0, &counts};
        Signals signals;
        trace_glossy(point.scene, seen.surface, -seen.ray.direction, path, 0, false, signals);
        float const motion = reflection_motion(point, planes, signals, glm::reflect(seen.ray.direction, seen.surface.normal));
        if (motion >= min_motion && ++reflected == min_reflected) return true;
    }
    return false;
}

bool is_hidden(MaskPoint const& point) {
    return !is_seen(point.scene, point.view, point.size, revisit(point.scene, point.view, point.hit));
}

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
    PathContext const path{{glm::ivec2{0}, 0, 0}, moment.time, &counts};
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
