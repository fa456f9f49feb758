#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>

namespace quell::tracer {

/// A light at one moment, in world space, with where it was one frame before: a flat convex polygon of three or four corners, or a sphere.
struct Emitter {
    glm::vec3 radiance{0.f};
    int corner_count = 0; ///< 0: sphere
    bool both_sides = false;
    std::array<glm::vec3, 4> corners{}, corners_before{}; ///< counter-clockwise seen from the emitting side
    glm::vec3 centre{0.f}, centre_before{0.f};
    float radius = 0;
    glm::mat3 turned_before{1.f}; ///< takes offsets from the centre to those of the previous frame

    [[nodiscard]] bool is_sphere() const { return corner_count == 0; }
    [[nodiscard]] glm::vec3 before(glm::vec3 point) const;
};

/// Irradiance from the emitter at a point, per unit of its radiance, clipped to the horizon, without shadows. Exact:
/// polygons by Lambert's formula (1760; Arvo 1994), spheres by Snyder, "Area light sources for real-time graphics" (1996).
[[nodiscard]] float irradiance(Emitter const& emitter, glm::vec3 position, glm::vec3 normal);

/// A point of the emitter, distributed (nearly) as its contribution to `irradiance`: uniform in solid angle, then resampled by the cosine
/// among a few lattice candidates (this many at most). Thus unshadowed irradiance times the mean visibility of such points is the shadowed irradiance.
[[nodiscard]] glm::vec3 sample_point(Emitter const& emitter, glm::vec3 position, glm::vec3 normal, glm::vec2 random, float choice,
                                     int candidates = 8);

} // namespace quell::tracer
