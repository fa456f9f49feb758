#pragma once

#include <denoise/linear_picture.hpp>

namespace quell::examples {

/// Two squared errors of a part of a picture: that of taking its guide as it is, and that of filtering the guide together with the light.
/// Means over the picture, weighted by how visible errors are.
struct GuideErrors {
    float noise = 0; ///< variance of the guide's own noise
    /// Structure of the guide that a filter of the noisy part loses: s n / (s + n), with s the variance of the guide's structure and n that
    /// of the part's noise, as of Wiener's filter.
    float loss = 0;
};

/// What a guide is.
enum class GuideKind {
    factor, ///< the part is the guide times its light
    added   ///< it is added to the rest of the part as it is
};

/// Estimates both errors from one frame, in windows of 5x5 pixels. In each, noise is the nugget of the variogram g, 2 g(1 pixel) -
/// g(2 pixels), in the direction in which it is least: edges, lines and textures of more than two pixels have none along themselves. Finer
/// textures are told from noise by the depth: what blurs a guide scatters depths too, while of a plane that is seen sharply the inverse
/// depth is a linear function of the place.
/// @param guide what is not filtered where it is taken as it is
/// @param depth of the frame; empty: not known
/// @param part  the light with the guide in it
/// @param whole the whole picture: says how visible errors are
[[nodiscard]] GuideErrors guide_errors(LinearView const& guide, GuideKind kind, LinearView const& part, LinearView const& whole,
                                       std::vector<float> const& depth);

} // namespace quell::examples
