#pragma once

#include <denoise/surface_links.hpp>

#include <glm/vec3.hpp>

#include <vector>

namespace quell::examples {

/// Of a pixel, or of a surface around it: sums over pairs of pixels. What each of two pixels of a surface has is laid beside the other's. A
/// light that is the same for both leaves
///
///     (a b' - a' b)^2 / (b^2 + b'^2)
///
/// of the picture's a and a', with b and b' their albedos, and (a - a')^2 / 2 without albedos. Noise gives both the same where albedo and
/// light have nothing to do with each other, and less to the first where they have.
struct AlbedoEvidence {
    float difference = 0; ///< the first less the second
    float squared = 0;    ///< squares of that
    float variation = 0;  ///< the second

    AlbedoEvidence& operator+=(AlbedoEvidence const& more) {
        difference += more.difference, squared += more.squared, variation += more.variation;
        return *this;
    }
    /// The same with another weight.
    [[nodiscard]] AlbedoEvidence weighted(float weight) const {
        return {difference * weight, squared * weight * weight, variation * weight};
    }
};

/// How far a sum must speak against an albedo: light varies more once it is divided by it.
struct AlbedoDoubt {
    float deviations; ///< so many of the sum's own
    float part;       ///< of the variation

    [[nodiscard]] bool holds(AlbedoEvidence const& sum) const;
};

/// That of each pixel.
/// @param light of a signal, in the picture
/// @param by    what it is divided by
[[nodiscard]] std::vector<AlbedoEvidence> albedo_evidence(SurfaceLinks const& surfaces, std::vector<glm::vec3> const& light,
                                                          std::vector<glm::vec3> const& by);

} // namespace quell::examples
