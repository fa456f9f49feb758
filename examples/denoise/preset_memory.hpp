#pragma once

#include <string>

namespace quell::examples {

/// How many frames before the first make a frame of a preset what it is in the whole sequence: to less than 0.1 % of FLIP. From the weight
/// that its history gives to old frames; 0 where it has none.
/// @param preset a name of quell::named_presets
[[nodiscard]] int usual_warm_up(std::string const& preset);

} // namespace quell::examples
