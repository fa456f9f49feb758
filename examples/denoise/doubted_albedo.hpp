#pragma once

#include <denoise/albedo_evidence.hpp>
#include <denoise/guide_images.hpp>

#include <quell/io/exr_image.hpp>
#include <quell/io/sequence_names.hpp>

#include <cstddef>
#include <deque>
#include <map>
#include <optional>
#include <string>

namespace quell::examples {

/// Finds where light varies more once it is divided by its albedo, or by the factor of its signal: there that is not the colour of what the
/// light fell on, such as the highlight that some renderers write for a rough metal. Sums over a surface in a window decide, where they
/// speak against the albedo beyond doubt. Sums of frames before are moved to where their surfaces are now; they fade. In a place of one
/// surface a constant stands for the albedo. Signals times their factors, or light by albedo, stay what they were.
class DoubtedAlbedo {
public:
    /// A frame. Planes are added to it, whose names begin with "quell:".
    /// @param by_albedo whether signals are divided by their albedo before they are denoised
    /// @param guides    the frame's
    /// @return the names of the frame as it is to be read; none where every albedo is believed
    [[nodiscard]] std::optional<io::SequenceNames> names_for(io::ExrImage& image, io::SequenceNames const& names, bool by_albedo,
                                                             long long number, GuideImages& guides);
    /// One sentence, where an albedo was not believed in one of the frames.
    [[nodiscard]] std::vector<std::string> remarks() const;

private:
    /// What is known after a frame, at every few pixels.
    struct Known {
        long long number;
        Extent size;
        std::vector<float> depth; ///< empty: not known
        std::map<std::size_t, std::vector<AlbedoEvidence>> of_signals;
    };
    std::deque<Known> known; ///< of the last frames: some are read again
    double most = 0;         ///< part of a frame's pixels

    [[nodiscard]] Known const* find(long long number, Extent size) const;
};

} // namespace quell::examples
