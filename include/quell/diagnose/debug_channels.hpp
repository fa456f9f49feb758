#pragma once

#include <quell/core/channel.hpp>
#include <quell/image/extent.hpp>

#include <string>
#include <vector>

namespace quell {

// What happens inside a Temporal stage, as images: a watched() pipeline makes them, debug_images() hands them out.

/// How many frames a pixel's value goes back, whether or not the blend policy counts them.
struct DebugLength : Channel<1> {
    static constexpr auto name = "history_length";
};
/// Which motion source found the past: 1 the first, 2 the second and so on, 0 none.
struct DebugSource : Channel<1> {
    static constexpr auto name = "motion_source";
};
/// Why the first motion source's place gives no past; a Rejection.
struct DebugRejection : Channel<1> {
    static constexpr auto name = "rejection";
};
/// How much a clamp moved the past, relative to itself (TRMV eq. 8).
struct DebugClamp : Channel<1> {
    static constexpr auto name = "clamp";
};
inline constexpr DebugLength debug_length;
inline constexpr DebugSource debug_source;
inline constexpr DebugRejection debug_rejection;
inline constexpr DebugClamp debug_clamp;
using DebugChannels = Channels<DebugLength, DebugSource, DebugRejection, DebugClamp>;

/// Why the first motion source gives no past, in the order in which that is looked for.
enum class Rejection {
    none,      ///< it does
    no_frame,  ///< there is no last frame
    no_motion, ///< the source has nothing to say of this pixel
    outside,   ///< what is seen here was not in the picture
    depth,     ///< all four neighbours there have another depth; or another
    normal,
    instance,
    other, ///< another test refuses them, or several tests some each
};

/// One number per pixel of what a Temporal stage did in the last run.
struct DebugImage {
    std::string signal; ///< whose pipeline it is
    Extent size;
    std::vector<float> values; ///< row by row
};

} // namespace quell
