#pragma once

#include <quell/frame/earlier.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

// What links keep of a frame for those behind it.

/// The colours of a frame, which light is multiplied by: those that Demodulate divides by.
struct SeenColour : InternalChannel<3> {
    static constexpr auto name = "seen_colour"; ///< of the channel
};
/// What the denoiser before made of a frame.
struct SeenPicture : InternalChannel<3> {
    static constexpr auto name = "seen_picture"; ///< of the channel
};
/// The depth of a frame.
struct SeenDepth : ExactChannel<1> {
    static constexpr auto name = "seen_depth"; ///< of the channel
};
/// Its motion, in pixels, without jitter.
struct SeenMotion : ExactChannel<2> {
    static constexpr auto name = "seen_motion"; ///< of the channel
};
/// From a sample of a frame to where the nearest surface of the 3x3 around was among the samples of the frame before: in pixels, with
/// jitter; outside the image where there is no frame before.
struct SeenVector : ExactChannel<2> {
    static constexpr auto name = "seen_vector"; ///< of the channel
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
