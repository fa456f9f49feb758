#pragma once

#include <quell/core/instruction_set.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

// How far from a pixel's trajectories PairGather looks for samples.

/// The same distance everywhere.
struct FixedFootprint {
    static constexpr bool adapts = false; ///< whether it depends on the mean's uncertainty
};
/// Where the gathered mean is uncertain, doubles the distance and adds the pixels beside the line.
struct AdaptiveFootprint {
    static constexpr bool adapts = true; ///< whether it depends on the mean's uncertainty
    float allowed_error = 0.2f;          ///< relative standard error of the mean from which on it is uncertain
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
