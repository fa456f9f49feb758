#pragma once

#include <gauntlet/world.hpp>

namespace quell::gauntlet {

/// Places of things in `court`.
enum CourtThing : std::size_t { court_floor, court_box, court_pillar, court_ball, court_screen, court_wall };

/// A floor under a sky with a pattern, a box, a pillar, a screen and a wall, and a ball that rolls.
[[nodiscard]] World court();
/// The same under a plain sky.
[[nodiscard]] World plain_court();
/// Drops before the sky, which fly upwards.
[[nodiscard]] World drops();

} // namespace quell::gauntlet
