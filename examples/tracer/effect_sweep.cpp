#include "effect_sweep.hpp"
#include "revisit.hpp"

namespace quell::tracer {
namespace {

/// Of the angle between the line from the light and the plane; shadows that fall flatter run away to infinity (as in ShadowMotion).
constexpr float min_sine = 0.02f;

Plane tangent_plane(ShutterMoment const& moment) {
    auto const surface = revisit(moment.scene, moment.view, moment.hit, moment.time).surface;
    return {surface.position, surface.normal};
}

} // namespace

glm::vec2 shadow_place(ShutterMoment const& moment, Signals const& signals, float sampled_at) {
    if (!signals.shadow_hit) return glm::vec2{not_a_number};
    auto const light = moment.scene.emitter_point(signals.emitter, signals.light, sampled_at, moment.time);
    auto const blocker = moment.scene.point(signals.shadow_hit, moment.time, When::now);
    auto const plane = tangent_plane(moment);
    if (std::abs(glm::dot(glm::normalize(blocker - light), plane.normal)) < min_sine) return glm::vec2{not_a_number};
    return moment.view.project(shadow_on(plane, light, blocker));
}

glm::vec2 reflection_place(ShutterMoment const& moment, Signals const& signals) {
    if (!signals.glossy_ray_hit) return glm::vec2{not_a_number};
    return moment.view.project(tangent_plane(moment).mirrored(moment.scene.point(signals.glossy_ray_hit, moment.time, When::now)));
}

} // namespace quell::tracer
