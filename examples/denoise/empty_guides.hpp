#pragma once

#include <quell/io/exr_image.hpp>
#include <quell/io/sequence_names.hpp>

#include <string>
#include <vector>

namespace quell::examples {

/// Passes of a frame that say nothing of any surface.
struct EmptyGuides {
    bool normal = false; ///< 0 on all
    bool depth = false;  ///< 0 everywhere, while normals show surfaces
    bool albedo = false; ///< black on all, while there is light
    bool noise = false;  ///< normals that light does not go with
};

/// Puts constants where a guide says nothing: a constant passes every test and stops no filter, while an empty one keeps pixels apart as if
/// each were another surface. A normal of 0 says nothing where there is depth, and becomes (0, 0, 1). A depth of 0 says nothing where there
/// is a normal, and becomes 1. What shows no surface stays as it is: the sky has neither.
/// @param image whose planes of normals and depth are changed
/// @return the passes that say nothing at all
[[nodiscard]] EmptyGuides fill_empty_guides(io::ExrImage& image, io::SequenceNames const& names);

/// The same for normals that are noise: each becomes (0, 0, 1).
/// @return whether they are
[[nodiscard]] bool fill_noisy_normals(io::ExrImage& image, io::SequenceNames const& names);

/// The passes that said nothing in the frames of a sequence so far.
class EmptyPasses {
    bool normal = false, depth = false, noise = false;
    bool albedo = true; ///< in all frames: a mirror that fills one is black

public:
    void add(EmptyGuides const& frame) {
        normal = normal || frame.normal, depth = depth || frame.depth, noise = noise || frame.noise, albedo = albedo && frame.albedo;
        is_first = false;
    }
    /// One sentence for each.
    [[nodiscard]] std::vector<std::string> remarks() const;

private:
    bool is_first = true;
};

} // namespace quell::examples
