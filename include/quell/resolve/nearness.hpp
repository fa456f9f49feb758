#pragma once

#include <quell/core/real.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// One by the depth: 0 where nothing is seen, so that what is far is near to nothing seen. Depths are compared by it.
/// @param depth of a surface; not finite: there is none
template <class Real> QUELL_KERNEL Real nearness(Real depth) { return masked(is_finite(depth), 1.f / max(depth, Real(1e-20f))); }

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
