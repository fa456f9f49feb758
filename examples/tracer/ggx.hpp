#pragma once

#include "math.hpp"

namespace quell::tracer {

/// A rough metal's surface. Directions are unit vectors with z along the normal.
struct Ggx {
    glm::vec3 base{1.f};
    float metallic = 1;
    float alpha = 0; ///< roughness squared; 0 is a perfect mirror

    /// Schlick's Fresnel reflectance, from base * metallic at normal incidence to `metallic` at grazing incidence.
    [[nodiscard]] glm::vec3 fresnel(float cosine) const;
    /// Smith's Lambda function.
    [[nodiscard]] float lambda(glm::vec3 direction) const;
    /// A microfacet normal among those that are visible from `out` (Heitz 2018, in the form of Dupuy and Benyoub, "Sampling visible
    /// GGX normals with spherical caps", 2023).
    [[nodiscard]] glm::vec3 sample_normal(glm::vec3 out, glm::vec2 random) const;
    /// Reflectance times cosine over the density of directions that `sample_normal` leads to: Fresnel times G2 / G1.
    [[nodiscard]] glm::vec3 weight(glm::vec3 out, glm::vec3 in, glm::vec3 microfacet) const;
};

} // namespace quell::tracer
