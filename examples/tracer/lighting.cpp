#include "lighting.hpp"

#include <vector>

namespace quell::tracer {
namespace {

/// Light that a surface reflects, by one light sample.
glm::vec3 scattered(PreparedScene const& scene, Surface const& surface, PathContext const& path, std::uint32_t depth) {
    auto const point = sample_pair(path.key, SampleUse::second_light_point, depth);
    auto const choice = sample_pair(path.key, SampleUse::second_light_choice, depth).x;
    auto const lighting = sample_lighting(scene, surface, path.time, point, choice);
    glm::vec3 light = lighting.irradiance / pi;
    if (lighting.sample.exists) {
        ++path.counts->shadow;
        if (scene.occluded(shadow_ray(surface, lighting.sample.position, path.time))) light = glm::vec3{0.f};
    }
    if (!scene.description().has_indirect_rays()) light += scene.description().background.ambient(surface.normal);
    return light;
}

} // namespace

glm::vec3 unshadowed_irradiance(PreparedScene const& scene, Surface const& surface, float time) {
    glm::vec3 sum{0.f};
    for (std::size_t i = 0; i < scene.emitter_count(); ++i) {
        auto const emitter = scene.emitter(i, time);
        sum += emitter.radiance * irradiance(emitter, surface.position, surface.normal);
    }
    return sum;
}

Lighting sample_lighting(PreparedScene const& scene, Surface const& surface, float time, glm::vec2 point, float choice) {
    // One buffer per thread: this is called several times per pixel, and the number of lights is whatever a file holds.
    static thread_local std::vector<float> weights;
    weights.clear();
    Lighting lighting;
    for (std::size_t i = 0; i < scene.emitter_count(); ++i) {
        auto const emitter = scene.emitter(i, time);
        auto const part = emitter.radiance * irradiance(emitter, surface.position, surface.normal);
        lighting.irradiance += part;
        weights.push_back(luminance(part));
    }
    if (!(luminance(lighting.irradiance) > 0)) return lighting;
    auto const chosen = choose(weights, point.x);
    auto const emitter = scene.emitter(chosen, time);
    auto const position = sample_point(emitter, surface.position, surface.normal, point, choice);
    lighting.sample = {position, emitter.before(position), chosen, true};
    return lighting;
}

Ray shadow_ray(Surface const& surface, glm::vec3 target, float time) {
    auto const origin = surface.origin(target - surface.position);
    auto const offset = target - origin;
    float const distance = glm::length(offset);
    // The ray ends short of the light, which must not shadow itself.
    return {origin, offset / distance, distance * (1 - 1e-4f) - surface.clearance, time};
}

glm::vec3 cosine_direction(glm::vec3 normal, glm::vec2 random) {
    float const radius = std::sqrt(random.x), turn = 2 * pi * random.y;
    return glm::normalize(Basis{normal}.world({radius * std::cos(turn), radius * std::sin(turn), std::sqrt(1 - random.x)}));
}

Incident incident(PreparedScene const& scene, Ray const& ray, PathContext const& path, float footprint_angle, bool count_lights) {
    auto const hit = scene.intersect(ray);
    if (!hit) return {scene.description().background.radiance(ray.direction), hit};
    auto const surface = surface_at(scene, ray, hit, footprint_angle);
    Incident result{glm::vec3{0.f}, hit};
    if (!surface.is_light || count_lights) result.radiance = surface.emission;
    if (surface.is_emitter) return result;
    auto const reflectance = surface.diffuse() + surface.base * surface.metallic;
    result.radiance += reflectance * scattered(scene, surface, path, count_lights ? 8u : 0u);
    return result;
}

} // namespace quell::tracer
