#pragma once

#include <quell/blend/blend_policy.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Exponential moving average with a fixed alpha (TRMV eq. 2). The first sample has weight 1, so its noise lasts for about 1 / alpha
/// frames. RunningMean avoids this, for one more number per pixel.
struct Exponential {
    static constexpr int farthest_tap = 0;
    float alpha = 0.1f; ///< weight of the newest frame, in (0, 1]

    /// 1 / alpha frames.
    [[nodiscard]] constexpr BlendMemory memory() const { return {.frames = 1.f / alpha}; }

    /// Blends with 1 - validity (1 - alpha).
    QUELL_KERNEL auto blend(auto px, auto past) const { return accumulate(px, past, 1.f - past.validity * (1.f - alpha)); }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
