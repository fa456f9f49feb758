#include "trace.hpp"
#include "ggx.hpp"

namespace quell::tracer {

void trace_shadow(PreparedScene const& scene, Surface const& surface, PathContext const& path, bool find_blocker, Signals& signals) {
    auto const ray = shadow_ray(surface, signals.light, path.time);
    ++path.counts->shadow;
    if (!find_blocker) {
        signals.visibility = scene.occluded(ray) ? 0.f : 1.f;
        return;
    }
    auto const hit = scene.intersect(ray);
    if (!hit) return;
    signals.visibility = 0;
    signals.shadow_hit = hit;
    signals.blocker = scene.point(hit, path.time, When::now);
    signals.blocker_previous = scene.point(hit, path.time, When::before);
}

void trace_glossy(PreparedScene const& scene, Surface const& surface, glm::vec3 to_viewer, PathContext const& path, float footprint_angle,
                  bool shade, Signals& signals) {
    Basis const basis{surface.normal};
    Ggx const metal{surface.base, surface.metallic, surface.roughness * surface.roughness};
    glm::vec3 const out{glm::dot(to_viewer, basis.x), glm::dot(to_viewer, basis.y), glm::dot(to_viewer, basis.z)};
    auto const microfacet = metal.sample_normal(out, sample_pair(path.key, SampleUse::glossy));
    auto const in = glm::reflect(-out, microfacet);
    auto const direction = glm::normalize(basis.world(in));
    // Light from below the surface is lost, as it is between the microfacets of a real one.
    if (in.z <= 0 || glm::dot(direction, surface.geometric_normal) <= 0) return;
    Ray const ray{surface.origin(direction), direction, infinity, path.time};
    ++path.counts->glossy;
    Incident arrived;
    if (shade)
        arrived = incident(scene, ray, path, footprint_angle + surface.roughness * surface.roughness * 0.5f, true);
    else
        arrived.hit = scene.intersect(ray);
    signals.glossy = metal.weight(out, in, microfacet) * arrived.radiance;
    if (!arrived.hit) return;
    signals.glossy_ray_hit = arrived.hit;
    signals.glossy_hit = scene.point(arrived.hit, path.time, When::now);
    signals.glossy_hit_previous = scene.point(arrived.hit, path.time, When::before);
}

void trace_indirect(PreparedScene const& scene, Surface const& surface, PathContext const& path, bool shade, Signals& signals) {
    signals.indirect_direction = cosine_direction(surface.normal, sample_pair(path.key, SampleUse::indirect));
    if (!scene.description().has_indirect_rays()) {
        signals.indirect = scene.description().background.ambient(surface.normal);
        return;
    }
    // Directions that the shading normal allows but the surface itself is in the way of see nothing.
    bool const free = glm::dot(signals.indirect_direction, surface.geometric_normal) > 0;
    if (!shade || !free) return;
    ++path.counts->indirect;
    Ray const ray{surface.origin(signals.indirect_direction), signals.indirect_direction, infinity, path.time};
    // Scattered rays see a blurred world: coarse texels make them less noisy, and they touch less memory.
    constexpr float scattered_footprint = 0.1f;
    signals.indirect = incident(scene, ray, path, scattered_footprint, false).radiance;
}

} // namespace quell::tracer
