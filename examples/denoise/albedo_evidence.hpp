#pragma once

#include <denoise/surface_links.hpp>

#include <glm/vec3.hpp>

#include <vector>

namespace quell::examples {

/// Of a pixel, or of a surface around it: sums over pairs of pixels. What each of two pixels of a surface has is laid beside the other's.
/// The light of both, l = (a + a') / (b + b'), leaves
///
///     (a - a' - l (b - b'))^2 / 2
///
/// of the picture's a and a', with b and b' their albedos, and (a - a')^2 / 2 is there without albedos. The first is more by l^2 (b - b')^2
/// / 2 where albedo and light have nothing to do with each other, and less by as much where the albedo is the light's.
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
