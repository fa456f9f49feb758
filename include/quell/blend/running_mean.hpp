#pragma once

#include <quell/blend/blend_policy.hpp>

namespace quell {

/// The exact mean of a pixel's last frames, until there are `cap` of them; from then on a moving average with alpha = 1 / cap. The only
/// form that is both unbiased at the start and bounded.
struct RunningMean {
    using keeps = Channels<HistoryLength>;
    float cap = 32.f; ///< frames, at least 1; where the host says how many samples a pixel has (KnownSamples{}), samples

    QUELL_KERNEL auto blend(auto px, auto past) const {
        using Real = typename decltype(px)::Real;
        auto const now = px.samples();
        auto const n = min(past[history_length] * past.validity + now, max(now, Real(cap)));
        return accumulate(px, past, now / n).with(history_length, n);
    }
};

/// RunningMean whose history shortens by as much as a clamp had to move it: stale samples are forgotten at once, not over `cap` frames.
struct Adaptive {
    using keeps = Channels<HistoryLength>;
    float cap = 32.f;         ///< frames, at least 1
    float sensitivity = 0.5f; ///< how much of the clamp's relative change is added to alpha

    QUELL_KERNEL auto blend(auto px, auto past) const {
        using Real = typename decltype(px)::Real;
        auto const n = min(past[history_length] * past.validity + 1.f, Real(cap));
        auto const alpha = min(1.f / n + past.clamped * sensitivity, Real(1.f));
        return accumulate(px, past, alpha).with(history_length, 1.f / alpha);
    }
};

} // namespace quell
