#pragma once

#include <quell/core/value.hpp>

namespace quell {

// Channels that policies make themselves: what they keep lives from frame to frame, what they emit until the frame's end. No host supplies
// them.

/// How many frames a pixel's value is the mean of; 0 where every sample so far was missing.
struct HistoryLength : MadeChannel<1> {
    static constexpr auto name = "history_length";
};
/// Mean and variance over time of the signal's luminance, kept by Welford's update.
struct LuminanceMean : MadeChannel<1> {
    static constexpr auto name = "luminance_mean";
};
struct LuminanceVariance : MadeChannel<1> {
    static constexpr auto name = "luminance_variance";
    static constexpr bool squared = true;
};
/// The variance of the luminance that a variance-guided filter works with.
struct Variance : MadeChannel<1> {
    static constexpr auto name = "variance";
    static constexpr bool squared = true;
};
/// The standard deviation of a clean-up filter, in pixels (TRMV section 5).
struct CleanUpDeviation : MadeChannel<1> {
    static constexpr auto name = "clean_up_deviation";
};

inline constexpr HistoryLength history_length;
inline constexpr LuminanceMean luminance_mean;
inline constexpr LuminanceVariance luminance_variance;
inline constexpr Variance variance;
inline constexpr CleanUpDeviation clean_up_deviation;

} // namespace quell
