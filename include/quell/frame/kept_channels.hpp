#pragma once

#include <quell/core/value.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

// Channels that policies make. Kept channels live from frame to frame, emitted channels until the end of the frame.

/// The number of frames that a pixel's history is the mean of; of samples, with KnownSamples{}. 0 where every sample so far was missing.
struct HistoryLength : InternalChannel<1> {
    static constexpr auto name = "history_length"; ///< for messages
};
/// Mean over time of the signal's luminance (Welford's update).
struct LuminanceMean : InternalChannel<1> {
    static constexpr auto name = "luminance_mean"; ///< for messages
};
/// Variance over time of the signal's luminance (Welford's update).
struct LuminanceVariance : InternalChannel<1> {
    static constexpr auto name = "luminance_variance"; ///< for messages
    static constexpr bool squared = true;              ///< half stores its root
};
/// The variance of the luminance that a variance-guided filter uses.
struct Variance : InternalChannel<1> {
    static constexpr auto name = "variance"; ///< for messages
    static constexpr bool squared = true;    ///< half stores its root
};
/// The standard deviation of the clean-up filter, in pixels (TRMV section 5).
struct CleanUpDeviation : InternalChannel<1> {
    static constexpr auto name = "clean_up_deviation"; ///< for messages
};
/// Mean of the albedo of the frames that a pixel's history is the mean of.
struct MeanAlbedo : InternalChannel<3> {
    static constexpr auto name = "mean_albedo"; ///< for messages
    static constexpr bool of_guides = true;     ///< there where the sample is missing
};
/// Mean of their normals: shorter than 1 where they differ, as at edges. 0 for misses.
struct MeanNormal : InternalChannel<3> {
    static constexpr auto name = "mean_normal"; ///< for messages
    static constexpr bool of_guides = true;     ///< there where the sample is missing
};

// What code indexes with: px[history_length].
/// @cond
inline constexpr HistoryLength history_length;
inline constexpr LuminanceMean luminance_mean;
inline constexpr LuminanceVariance luminance_variance;
inline constexpr Variance variance;
inline constexpr CleanUpDeviation clean_up_deviation;
inline constexpr MeanAlbedo mean_albedo;
inline constexpr MeanNormal mean_normal;
/// @endcond

} // namespace quell::inline QUELL_INSTRUCTION_SET
