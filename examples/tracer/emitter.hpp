#pragma once

#include "math.hpp"

#include <array>
#include <cstddef>
#include <span>

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

/// A point of the emitter, distributed as its contribution to `irradiance`, up to a minute bias: uniform in solid angle, then corrected by
/// the cosine. Thus unshadowed irradiance times the mean visibility of such points is the shadowed irradiance.
[[nodiscard]] glm::vec3 sample_point(Emitter const& emitter, glm::vec3 position, glm::vec3 normal, glm::vec2 random, float choice);

/// Picks one in proportion to its weight, and stretches the random number's interval so that it can serve again, as well distributed as
/// before.
[[nodiscard]] std::size_t choose(std::span<float const> weights, float& random);

} // namespace quell::tracer
