#pragma once

#include "../images.hpp"

#include <string>
#include <vector>

namespace quell::tests {

inline constexpr Extent image_size{37, 21}; // not a whole number of packs

/// Prints what does not hold, and counts it.
void check(bool holds, std::string const& what);

/// Looks from (0, 0, 0) along -z.
Camera usual_camera();

/// What presets::trmv() makes of three frames seen by this camera.
std::vector<float> images_by_trmv(Camera const& camera);
void check_presets();
void check_opt_in();

} // namespace quell::tests
