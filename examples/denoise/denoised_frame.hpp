#pragma once

#include <denoise/accumulated_guides.hpp>
#include <denoise/linear_picture.hpp>

#include <quell/execute/executor.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace quell::examples {

/// A frame when it is denoised, with what lies outside of its display window.
struct DenoisedFrame {
    Region canvas; ///< what the pictures show, counted from the display window's corner
    LinearPicture picture;
    std::vector<LinearPicture> signals;   ///< times their factors: what each adds to the picture
    std::vector<float> alpha;             ///< of the film; empty where the files have none
    std::vector<AccumulatedGuide> guides; ///< where the preset accumulates them

    /// A plane of the file that is added, and what it is multiplied by.
    struct Added {
        std::vector<float> const* values; ///< the file's, as long as the SequenceDenoiser has this frame
        float scale, offset;
    };
    std::array<std::vector<Added>, 3> added; ///< by component
};

} // namespace quell::examples
