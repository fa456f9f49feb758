#pragma once

#include "results.hpp"

#include <iosfwd>

namespace quell::stability {

/// Says which promises don't hold, which hold though they are known not to, and how many hold. Returns how many are broken that aren't
/// known limits.
int judge(Results const& results, std::ostream& out);

} // namespace quell::stability
