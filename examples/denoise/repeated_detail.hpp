#pragma once

#include <quell/frame/channels.hpp>
#include <quell/image/planar.hpp>
#include <quell/metrics/picture.hpp>

#include <vector>

namespace quell::examples {

/// Tells texture of guides from their noise: the finest detail is noise as far as the frame before had another one there. Over a window,
/// the share that stays is the sum of the product of both frames' detail over the sum of the square of that before. Moving detail between
/// pixels takes as much off the product as off the square where it is finer than pixels, and less where it is wider, so that texture stays.
struct RepeatedDetail {
    float deviation = .7f;  ///< of the Gaussian that detail is finer than, in pixels
    int radius = 16;        ///< of the windows, in pixels
    int light_radius = 4;   ///< of those that say how much light guides are multiplied by
    float most_scale = 4.f; ///< light of samples is scaled by at most so much, or by its inverse
    float most = 3.f;       ///< what guides add, and their detail, is at most so many times the light around
};

/// The finest detail of a picture; what is not finite counts as 0.
[[nodiscard]] metrics::Picture finest_detail(RepeatedDetail const& rule, metrics::Picture picture);

/// A colour of guides, and a signal's light times it.
struct ColouredSignal {
    metrics::Picture colour;
    metrics::Picture product; ///< of single samples or denoised
};
/// What the finest detail of guides adds to the picture: that of each colour times its light, and that of what is added as it is. How a
/// window's light is divided among the signals is taken from their products; how much light it has, from the picture, because that of few
/// samples differs from frame to frame, so that texture would seem to be new.
/// @param added   what has no light; without pixels: nothing is added
/// @param picture denoised; detail is at most some times the light around it
[[nodiscard]] metrics::Picture detail_of_guides(RepeatedDetail const& rule, std::vector<ColouredSignal> signals,
                                                metrics::Picture const& added, metrics::Picture const& picture);

/// Limits detail, or what else adds to a picture, by its light around each pixel. What is not finite becomes 0.
void limit_detail(RepeatedDetail const& rule, metrics::Picture const& picture, metrics::Picture& detail);

/// How much of detail the frame before has too: from 0 to 1, for each pixel; 1 where that is not known.
/// @param detail  that guides add to the picture
/// @param picture bright and dark parts of it count alike
/// @param motion  a view of where each surface was in the frame before, less where it is, in pixels; not finite: unknown
/// @param before  the same detail of the frame before; without pixels: there was none
[[nodiscard]] std::vector<float> repeated_share(RepeatedDetail const& rule, metrics::Picture const& detail, metrics::Picture const& picture,
                                                ViewOf<Planar<>, Motion> motion, metrics::Picture const& before);

} // namespace quell::examples
