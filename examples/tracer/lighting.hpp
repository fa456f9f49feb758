#pragma once

#include "sampler.hpp"
#include "surface.hpp"

namespace quell::tracer {

[[nodiscard]] inline float luminance(glm::vec3 colour) { return glm::dot(colour, glm::vec3{0.2126f, 0.7152f, 0.0722f}); }

/// The one point on one light that stands for all lights at a surface point.
struct LightSample {
    glm::vec3 position{not_a_number}, position_before{not_a_number};
    std::size_t emitter = 0; ///< which of the scene's lights
    bool exists = false;     ///< false: no light is above the horizon
};

/// Irradiance from all lights without shadows, free of noise, and the light sample: a light in proportion to the luminance of what it
/// contributes, then a point on it (see `sample_point`).
struct Lighting {
    glm::vec3 irradiance{0.f};
    LightSample sample;
};

[[nodiscard]] glm::vec3 unshadowed_irradiance(PreparedScene const& scene, Surface const& surface, float time);
[[nodiscard]] Lighting sample_lighting(PreparedScene const& scene, Surface const& surface, float time, glm::vec2 point, float choice);

/// The ray that asks whether a light sample is seen.
[[nodiscard]] Ray shadow_ray(Surface const& surface, glm::vec3 target, float time);

/// Which point of the sample sequence a path uses, and where it counts its rays.
struct PathContext {
    SampleKey key;
    float time = 0;
    RayCounts* counts;
};

/// Radiance that comes back along a reflected or scattered ray from the first surface that it meets. Light that is met directly counts only
/// if `count_lights`. Metal scatters its light evenly, as an ideally rough one would.
struct Incident {
    glm::vec3 radiance{0.f};
    Hit hit;
};
[[nodiscard]] Incident incident(PreparedScene const& scene, Ray const& ray, PathContext const& path, float footprint_angle,
                                bool count_lights);

/// A direction around the normal with a density proportional to the cosine.
[[nodiscard]] glm::vec3 cosine_direction(glm::vec3 normal, glm::vec2 random);

} // namespace quell::tracer
