#pragma once

#include <quell/core/instruction_set.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Pixels of a frame with guides that no scene has, which are repaired (docs/channels.md, impossible guides). A pixel without a surface
/// needs no normal.
struct RepairedGuides {
    long long pixels = 0; ///< with one or more
    long long albedo = 0; ///< with a component outside [0, 1]
    long long normal = 0; ///< of another length than 1 or 0
    long long depth = 0;  ///< 0, negative or NaN
    long long motion = 0; ///< not finite: such pixels have no history

    /// Adds those of another frame.
    RepairedGuides& operator+=(RepairedGuides const& other) {
        pixels += other.pixels, albedo += other.albedo, normal += other.normal, depth += other.depth, motion += other.motion;
        return *this;
    }
};

/// Counts of the runs with one history.
struct Statistics {
    long long frames = 0;           ///< since the last reset
    long long missing_samples = 0;  ///< in the last frame: not finite, a component beyond 1e16, or negative luminance
    RepairedGuides repaired_guides; ///< in the last frame
    /// Light that SuppressFireflies took away in the last frame: sum of luminance, in the units of the host's samples. The same for any
    /// number of threads.
    double suppressed = 0;
    long long resets = 0; ///< how often history was dropped: first frame, new size, gap in the frame numbers, forget()
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
