#pragma once

namespace quell {

// How far from a pixel's paths PairGather looks for samples.

/// As far everywhere.
struct FixedFootprint {
    static constexpr bool adapts = false;
};
/// Where the gathered mean is uncertain, samples count from twice as far away, and the pixels beside the line are looked at too.
struct AdaptiveFootprint {
    static constexpr bool adapts = true;
    float allowed_error = 0.2f; ///< of the mean: its standard error, relatively, from which on it is uncertain
};

} // namespace quell
