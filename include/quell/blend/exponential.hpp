#pragma once

#include <quell/blend/blend_policy.hpp>

namespace quell {

/// A moving average in which the newest frame weighs `alpha` (TRMV eq. 2). Starts from the first sample, whose noise it forgets slowly:
/// RunningMean is better wherever one number a pixel can be kept.
struct Exponential {
    float alpha = 0.1f; ///< in (0, 1]

    QUELL_KERNEL auto blend(auto px, auto past) const { return accumulate(px, past, 1.f - past.validity * (1.f - alpha)); }
};

} // namespace quell
