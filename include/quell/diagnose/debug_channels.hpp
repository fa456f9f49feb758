#pragma once

#include <quell/core/channel.hpp>
#include <quell/image/extent.hpp>

#include <string>
#include <vector>

namespace quell::inline QUELL_INSTRUCTION_SET {

// What a Temporal stage does, as images: watched() pipelines make them, debug_images() returns them.

/// History length: number of frames since the pixel's past was last rejected, at least 1, whether or not the blend policy counts them.
struct DebugLength : Channel<1> {
    static constexpr auto name = "history_length";
};
/// Index of the motion source that found the past: 1 the first, 2 the second, ..., 0 none.
struct DebugSource : Channel<1> {
    static constexpr auto name = "motion_source";
};
/// Why the first motion source gave no past: the number of a Rejection.
struct DebugRejection : Channel<1> {
    static constexpr auto name = "rejection";
};
/// How far a clamp moved the past, relative to the past (TRMV eq. 8); 0 without a past.
struct DebugClamp : Channel<1> {
    static constexpr auto name = "clamp";
};
/// The channel DebugLength.
inline constexpr DebugLength debug_length;
/// The channel DebugSource.
inline constexpr DebugSource debug_source;
/// The channel DebugRejection.
inline constexpr DebugRejection debug_rejection;
/// The channel DebugClamp.
inline constexpr DebugClamp debug_clamp;
/// All of them.
using DebugChannels = Channels<DebugLength, DebugSource, DebugRejection, DebugClamp>;

/// Why the first motion source gives no past, in the order of the tests.
enum class Rejection {
    none,          ///< there is a past
    no_frame,      ///< the history is empty
    no_motion,     ///< the source has no vector, or no validity, for this pixel
    outside,       ///< the place is outside the image
    depth_test,    ///< the depth test rejects all four taps
    normal_test,   ///< the normal test does
    instance_test, ///< the instance test does
    other_test,    ///< another test does, or several tests reject some taps each
};

/// One debug channel of one pipeline, from the last run.
struct DebugImage {
    std::string signal;        ///< name of the signal that the pipeline denoises
    Extent size;               ///< in pixels
    std::vector<float> values; ///< row by row from the top
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
