#pragma once

#include <quell/blend/blend_policy.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Exact mean of a pixel's samples until there are `cap` of them, then an exponential average with alpha = 1 / cap. So there is no bias at
/// the start, and old light fades.
struct RunningMean {
    using keeps = Channels<HistoryLength>;
    static constexpr int farthest_tap = 0;
    float cap = 32.f; ///< in frames, at least 1; in samples where the host says how many a pixel has (KnownSamples{})

    /// `cap` frames.
    [[nodiscard]] constexpr BlendMemory memory() const { return {.frames = cap}; }

    /// alpha = samples now / samples in the new mean.
    QUELL_KERNEL auto blend(auto px, auto past) const {
        using Real = typename decltype(px)::Real;
        auto const now = px.samples();
        auto const n = min(past[history_length] * past.validity + now, max(now, Real(cap)));
        return accumulate(px, past, now / n).with(history_length, n);
    }
};

/// RunningMean whose history shortens when a clamp moves it: wrong history fades at once, not over `cap` frames. Goes inside Clamped.
/// Counts every frame as one sample, also with KnownSamples{}.
struct Adaptive {
    using keeps = Channels<HistoryLength>;
    static constexpr int farthest_tap = 0;
    float cap = 32.f;         ///< in frames, at least 1
    float sensitivity = 0.5f; ///< share of the clamp's relative change that is added to alpha

    /// `cap` frames.
    [[nodiscard]] constexpr BlendMemory memory() const { return {.frames = cap}; }

    /// alpha = min(1 / n + sensitivity * clamped, 1); the history length becomes 1 / alpha.
    QUELL_KERNEL auto blend(auto px, auto past) const {
        using Real = typename decltype(px)::Real;
        auto const n = min(past[history_length] * past.validity + 1.f, Real(cap));
        auto const alpha = min(1.f / n + past.clamped * sensitivity, Real(1.f));
        return accumulate(px, past, alpha).with(history_length, 1.f / alpha);
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
