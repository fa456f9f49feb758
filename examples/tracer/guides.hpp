#pragma once

#include "trace.hpp"
#include "view.hpp"

namespace quell::tracer::detail {

/// What a primary ray met.
struct Seen {
    Ray ray;
    Hit hit;
    Surface surface;

    [[nodiscard]] bool has_reflectance() const { return hit && !surface.is_emitter; }
    [[nodiscard]] glm::vec3 albedo() const { return has_reflectance() ? surface.diffuse() : glm::vec3{1.f}; }
    [[nodiscard]] float roughness() const { return has_reflectance() ? surface.roughness : 1.f; }
};

/// What a primary ray sees.
/// @param met a number in [0, 1) that decides which surfaces of partial coverage it meets
inline Seen seen_along(PreparedScene const& scene, View const& view, Ray const& ray, float met) {
    Seen seen{ray, {}, {}};
    seen.hit = scene.first_hit(seen.ray, met);
    if (seen.hit)
        seen.surface = surface_at(scene, seen.ray, seen.hit, view.pixel_angle());
    else
        seen.surface.normal = -seen.ray.direction;
    return seen;
}

/// The guides of one sample, or of a pixel whose samples may have seen different points.
struct Guides {
    glm::vec3 normal{0.f}, albedo{0.f};
    float roughness = 0;
    glm::vec2 motion{0.f};
    glm::vec3 previous{not_a_number}; ///< where the point was one frame before; NaN for the sky
};

template <class Wanted> Guides guides_of(PreparedScene const& scene, Seen const& seen, View const& view, View const& before) {
    Guides guides{seen.surface.normal, seen.albedo(), seen.roughness()};
    if constexpr (Rays<Wanted>::previous)
        if (seen.hit) guides.previous = scene.point(seen.hit, seen.ray.time, When::before);
    // Both ends are projected, so that rounding cancels and what stands still has a motion of exactly zero. Neither knows of jitter.
    if constexpr (Wanted::template has<Motion>)
        guides.motion = seen.hit ? before.project(guides.previous) - view.project(scene.point(seen.hit, seen.ray.time, When::now))
                                 : before.project(seen.ray.direction, 0) - view.project(seen.ray.direction, 0);
    return guides;
}

/// The guides of a pixel. Of a single sample they are the sample's, to the bit.
class MeanGuides {
public:
    void add(Guides const& next) {
        if (++count == 1) {
            mean = next;
            first_normal = next.normal;
            return;
        }
        float const part = 1 / static_cast<float>(count);
        mean.normal += (next.normal - mean.normal) * part;
        mean.albedo += (next.albedo - mean.albedo) * part;
        mean.roughness += (next.roughness - mean.roughness) * part;
        mean.motion += (next.motion - mean.motion) * part;
    }
    [[nodiscard]] Guides value() const {
        auto result = mean;
        if (count > 1) {
            float const length = glm::length(mean.normal);
            // Floor and ceiling cancel where they meet at the horizon; what is left then is rounding.
            result.normal = length > 1e-3f ? mean.normal / length : first_normal;
        }
        return result;
    }

private:
    Guides mean;
    glm::vec3 first_normal{0.f};
    int count = 0;
};

} // namespace quell::tracer::detail
