#pragma once

#include <denoise/linear_picture.hpp>

#include <quell/frame/channels.hpp>
#include <quell/image/planar.hpp>

#include <vector>

namespace quell::examples {

/// Tells texture of guides from their noise: the finest detail is noise as far as the frame before had another one there. Over a window,
/// the share that stays is the sum of the product of both frames' detail over the sum of the square of that before. Moving detail between
/// pixels takes as much off the product as off the square where it is finer than pixels, and less where it is wider, so that texture stays.
///
/// A picture has detail of other kinds too, such as edges of light and of lamps. It is that of guides as far as both are correlated.
struct RepeatedDetail {
    float deviation = .7f; ///< of the Gaussian that detail is finer than, in pixels
    int radius = 16;       ///< of the windows, in pixels
    float alike = 6.f;     ///< detail whose correlation with that of guides is a sixth counts as theirs: colours that were anti-aliased are
                           ///< means of some nine frames' samples, and light has noise of its own
    int light_radius = 4;  ///< of those that say how much light guides are multiplied by
    float most = 3.f;      ///< what guides add, and their detail, is at most so many times the light around
};

/// The finest detail of a picture; what is not finite counts as 0.
[[nodiscard]] LinearPicture finest_detail(RepeatedDetail const& rule, LinearView const& picture);

/// What the finest detail of a signal's colour adds to the picture.
/// @param colour that the signal is multiplied by
/// @param signal light times its colour, of single samples or denoised
[[nodiscard]] LinearPicture detail_of_colour(RepeatedDetail const& rule, LinearView const& colour, LinearView const& signal);

/// Limits detail, or what else adds to a picture, by its light around each pixel. What is not finite becomes 0.
void limit_detail(RepeatedDetail const& rule, LinearView const& picture, LinearPicture& detail);

/// How much of a picture's finest detail is that of its guides: from 0 to 1, for each pixel.
/// @param detail  of the picture
/// @param guides  what they add to it in their finest detail
/// @param picture bright and dark parts of it count alike
[[nodiscard]] std::vector<float> share_of_guides(RepeatedDetail const& rule, LinearView const& detail, LinearView const& guides,
                                                 LinearView const& picture);

/// How much of detail the frame before has too: from 0 to 1, for each pixel; 1 where that is not known.
/// @param detail  that guides add to the picture
/// @param picture bright and dark parts of it count alike
/// @param motion  a view of where each surface was in the frame before, less where it is, in pixels; not finite: unknown
/// @param before  the same detail of the frame before; without pixels: there was none
[[nodiscard]] std::vector<float> repeated_share(RepeatedDetail const& rule, LinearView const& detail, LinearView const& picture,
                                                ViewOf<Planar<>, Motion> motion, LinearView const& before);

} // namespace quell::examples
