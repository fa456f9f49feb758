#pragma once

#include "results.hpp"
#include "scored_sequence.hpp"

namespace quell::stability {

/// Making::long_run frames of `room`, a few dozen of them over and over, with cuts, other sizes and bursts of what is no number: memory
/// stays, errors stay, and all is finite.
void soak(Making const& making, bool quiet, Results& results);

} // namespace quell::stability
