#pragma once

#include "fit/contender.hpp"

namespace quell::bench {

/// A few simple ones for the rest and for shadows. Compiled by themselves, since that takes long.
[[nodiscard]] std::vector<Contender> small_contenders();

} // namespace quell::bench
