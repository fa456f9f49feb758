#pragma once

#include "fit/contender.hpp"

namespace quell::bench {

/// A few simple ones for the rest and for shadows, which say that they take 1, 2, 8, 16, 32 and 64 ms, whatever the machine does: what is
/// found doesn't depend on how busy it is. Compiled by themselves, since that takes long.
[[nodiscard]] std::vector<Contender> small_contenders();

} // namespace quell::bench
