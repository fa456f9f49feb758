#pragma once

#include <quell/io/sequence_names.hpp>
#include <quell/metrics/picture.hpp>

#include <vector>

namespace quell::examples {

/// What a split goes by.
struct SplitRule {
    bool by_albedo = false;  ///< whether signals are divided by their albedo before they are denoised
    bool finds_noise = true; ///< whether what has noisy guides goes to the rest
};

/// How the light of one frame is divided among the signals that are denoised.
struct LightSplit {
    /// By which each is read from the image: those of the sequence, and last the rest. That is the light which none of the others holds, as
    /// one picture that is not divided by anything.
    std::vector<io::SignalNames> signals;
    std::vector<bool> active;      ///< which of them have light in this frame
    std::vector<io::Source> added; ///< what is taken as it is, one source per component; may be empty
};

/// Divides a frame's light, from this frame alone, so that the signals and what is added sum up to the picture in each pixel and component:
///
/// - Where they hold less than the picture, what is left over goes to the rest.
/// - Where they hold more, what is added is scaled down first, and then all signals in proportion.
/// - A signal whose colour (its factor, or the albedo that it is divided by) is noisy, and an added part that is noisy, go to the rest too.
///
/// Differences that the files' rounding explains do not count. Of a sequence that doesn't name the picture, or of a frame that lacks it,
/// the signals and what is added are taken to be all.
/// @param image the frame; planes of the split are added to it, whose names begin with "quell:"
[[nodiscard]] LightSplit split_light(io::ExrImage& image, io::SequenceNames const& names, SplitRule const& rule);

/// The planes that this takes of a file beside those of the signals: of factors, of what is added, and of the picture where the file has
/// it.
[[nodiscard]] std::vector<std::string> split_planes(io::ExrFile const& file, io::SequenceNames const& names);

/// Of a frame whose light was divided: what turns the history of each signal of the sequence into that of the same light in the rest, and
/// back. For frames in which a signal begins or ceases to be denoised by itself.
struct RestShares {
    std::vector<metrics::Picture> colours; ///< of each signal: what its light is multiplied by in the picture
    std::vector<metrics::Picture> shares;  ///< of each signal that was in the rest: which part of it that was, from 0 to 1; else empty
};
/// @param image the frame
/// @param split how its light was divided
[[nodiscard]] RestShares rest_shares(io::ExrImage const& image, LightSplit const& split, io::SequenceNames const& names,
                                     SplitRule const& rule);

/// The name that the rest goes by.
inline constexpr auto rest_name = "rest";
/// Whether a sequence's frames can have a rest beside other signals: where there is just one signal and nothing is added, either of them
/// is the picture.
[[nodiscard]] bool has_several_signals(io::SequenceNames const& names);

/// Three components as a picture; where there are no sources, `otherwise` everywhere.
[[nodiscard]] metrics::Picture picture_of(io::ExrImage const& image, std::vector<io::Source> const& sources, float otherwise);

} // namespace quell::examples
