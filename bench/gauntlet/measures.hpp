#pragma once

#include <quell/metrics/picture.hpp>

#include <vector>

namespace quell::gauntlet {

/// Root of the mean square difference of linear colours, over the pixels that a mask selects (an empty one: all). 0 where there are none.
[[nodiscard]] double colour_error(metrics::Picture const& picture, metrics::Picture const& reference, metrics::Mask const& mask = {});

/// The same of each window of 25x25 pixels, every fifth one, as a screen shows the pictures.
[[nodiscard]] std::vector<double> window_errors(metrics::Picture const& picture, metrics::Picture const& reference);

/// Of filters that look around, most lies within so many pixels.
inline constexpr int around_broken = 4;

/// Pixels that lie farther than this from all pixels of a mask.
[[nodiscard]] metrics::Mask away_from(metrics::Mask const& mask, Extent size, int distance);

} // namespace quell::gauntlet
