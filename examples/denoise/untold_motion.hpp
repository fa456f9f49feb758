#pragma once

#include <denoise/guide_images.hpp>
#include <denoise/smooth_motion.hpp>

#include <quell/io/exr_image.hpp>
#include <quell/io/sequence_names.hpp>

#include <array>
#include <map>
#include <optional>
#include <vector>

namespace quell::examples {

/// Finds motion that vectors leave out, from what two frames in a row show (found_motion()):
///
/// - of the background, by its light. Cycles writes 0 for the sky, and no renderer knows of clouds in a picture of it.
/// - of all surfaces together, by their colours, which have no noise of light. Cycles leaves out changes of the lens: focal length and
/// shift.
///
/// Frames are told of in order; one whose frame before was not told of stays as it is.
class UntoldMotion {
public:
    /// Adds to a frame's vectors where its parts were in the frame before, as far as that can be seen.
    /// @param image     whose planes of vectors are changed
    /// @param is_opaque whether the film is: behind a transparent one is no background
    /// @param images    the frame's guides
    void tell(io::ExrImage& image, io::SequenceNames const& names, long long number, bool is_opaque, GuideImages& images);
    /// Adds to a frame's vectors where its parts will be, where the frame after has been told of. @return whether that is known of one
    bool tell_next(io::ExrImage& image, io::SequenceNames const& names, long long number, GuideImages& images) const;

private:
    struct Shown {
        long long number;
        Pyramid pyramid;
    };
    struct Part {
        std::optional<Shown> last{};
        std::map<long long, SmoothMotion> found{}; ///< by number, of the last few frames
    };
    std::array<Part, 2> parts; ///< background, surfaces
};

} // namespace quell::examples
