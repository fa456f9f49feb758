#pragma once

#include <denoise/denoiser.hpp>

#include <quell/io/sequence_names.hpp>

#include <array>
#include <memory>
#include <vector>

namespace quell::examples {

/// A guide of the picture that was accumulated with its light, for a denoiser behind quell.
struct AccumulatedGuide {
    std::string name;                      ///< mean_albedo or mean_normal
    std::array<char const*, 3> components; ///< their names in files
    LinearPicture values;
};

/// Whether a preset accumulates guides.
[[nodiscard]] inline bool accumulates_guides(Preset const& preset) { return !way_of(preset).guides.empty(); }

/// Accumulates the guides of a picture, which files may have in parts: the albedo of all of them, and normals. They are accumulated with
/// the whole picture, whose samples say where the light has changed.
class PictureGuides {
    std::unique_ptr<Denoiser> denoiser; ///< null before the first frame
    Preset preset;
    int threads;

public:
    /// @param preset one that accumulates guides
    PictureGuides(Preset preset, int threads);

    /// The next frame's guides, from the planes of its light and colours. Planes are added to the image, whose names begin with "quell:".
    [[nodiscard]] std::vector<AccumulatedGuide> next(io::ExrImage& image, io::SequenceNames const& names, long long number,
                                                     GuideImages& guides);
    void release_scratch();
    [[nodiscard]] double milliseconds() const { return denoiser ? denoiser->milliseconds() : 0.; }
    [[nodiscard]] double bytes_per_pixel() const { return denoiser ? denoiser->bytes_per_pixel() : 0.; }
};

} // namespace quell::examples
