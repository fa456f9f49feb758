#pragma once

#include <denoise/linear_picture.hpp>

#include <quell/io/sequence_names.hpp>

#include <optional>
#include <vector>

namespace quell::examples {

/// What a split goes by.
struct SplitRule {
    bool by_albedo = false;        ///< whether signals are divided by their albedo before they are denoised
    std::string alpha = {};        ///< the plane of the film's alpha, where it is denoised; else empty
    bool carries_alpha = true;     ///< whether a signal can have alpha in it
    std::string film = {};         ///< the plane of the film's alpha, denoised or not; empty: the film is opaque
    float samples_of_guides = 1.f; ///< by which the variance of guides is divided before they are multiplied by
};

/// How the light of one frame is divided among the signals that are denoised.
struct LightSplit {
    /// By which each is read from the image: those of the sequence, and last the rest. That is the light which none of the others holds, as
    /// one picture that is not divided by anything.
    std::vector<io::SignalNames> signals;
    std::vector<bool> active;      ///< which of them have light in this frame
    std::vector<io::Source> added; ///< what is taken as it is, one source per component; may be empty
    std::vector<float> kept_alpha; ///< the part of alpha that is taken as it is, where alpha is denoised; else empty
    bool shares_alpha = false;     ///< whether alpha was divided by the lights' shares, which are noisy

    /// The signal that has alpha in it, where alpha is denoised: the only one, or else the rest. Alpha is denoised by the weights of the
    /// light that it belongs to: where a part of a pixel's light is multiplied by a colour as it is, that part of alpha is taken as it is
    /// too.
    std::optional<std::size_t> alpha_with{};

    /// Where no light speaks for alpha, which is then denoised as a signal of its own: see unlit_film(). Empty: nowhere.
    std::vector<bool> own_alpha{};
    io::ChannelNames names_of_own_alpha{}; ///< by which that signal is read; elsewhere it has no samples
};

/// Divides a frame's light, from this frame alone, so that the signals and what is added sum up to the picture in each pixel and component:
///
/// - Where they hold less than the picture, what is left over goes to the rest.
/// - Where they hold more, what is added is scaled down first, and then all signals in proportion.
/// - Where the picture is taken as one, all of it is the rest.
/// - Where the film and the picture are empty, what light is multiplied by is 0: there it is of what the film does not show, as a shadow
///   catcher, whose light is no part of the picture.
///
/// Differences that the files' rounding explains do not count. Of a sequence that doesn't name the picture, or of a frame that lacks it,
/// the signals and what is added are taken to be all.
/// @param image  the frame; planes of the split are added to it, whose names begin with "quell:"
/// @param as_one whether the picture is taken as one
[[nodiscard]] LightSplit split_light(io::ExrImage& image, io::SequenceNames const& names, SplitRule const& rule, bool as_one);

/// Whether a frame is better filtered as one picture, from this frame alone: where colours (factors, or the albedo that a signal is divided
/// by) and what is added, or the rest, are so noisy that this is worse than what a filter loses of them.
[[nodiscard]] bool is_better_as_one(io::ExrImage const& image, io::SequenceNames const& names, SplitRule const& rule);

/// The picture of a frame: as the file has it, or else the sum of its signals and of what is added.
[[nodiscard]] ReadPicture whole_picture(io::ExrImage const& image, io::SequenceNames const& names);

/// The planes that this takes of a file beside those of the signals: of factors, of what is added, and of the picture where the file has
/// it.
[[nodiscard]] std::vector<std::string> split_planes(io::ExrListing const& file, io::SequenceNames const& names);

/// Of a frame: what turns the histories of its signals into that of the whole picture, and back. For frames in which that begins or ceases
/// to be filtered as one.
struct SignalShares {
    /// Of each signal, and last of the rest: what its light is multiplied by in the picture, without its noise.
    std::vector<LinearPicture> colours;
    std::vector<LinearPicture> shares; ///< of each signal, and last of the rest: which part of the picture it is, from 0 to 1
    LinearPicture added;               ///< and what no signal has, without its noise
};
[[nodiscard]] SignalShares signal_shares(io::ExrImage const& image, io::SequenceNames const& names, SplitRule const& rule);

/// The name that the rest goes by.
inline constexpr auto rest_name = "rest";
/// Whether a sequence's frames can have a rest beside other signals: where there is just one signal and nothing is added, either of them
/// is the picture.
[[nodiscard]] bool has_several_signals(io::SequenceNames const& names);

/// Three components as a picture; where there are no sources, `otherwise` everywhere.
/// @param image has to outlive it
[[nodiscard]] ReadPicture picture_of(io::ExrImage const& image, std::vector<io::Source> const& sources, float otherwise);
/// The light of a signal.
[[nodiscard]] ReadPicture light_of(io::ExrImage const& image, io::SignalNames const& signal, float otherwise = 0.f);
/// Puts a picture among planes, by names that begin with "quell:". Returns what reads it.
[[nodiscard]] std::vector<io::Source> put_picture(std::vector<io::Plane>& planes, std::string const& name, LinearView const& picture);
/// The same, rounded as the planes that it stands for: what that explains is no light.
[[nodiscard]] std::vector<io::Source> put_picture(io::ExrImage& image, std::string const& name, LinearView const& picture,
                                                  std::vector<io::Source> const& instead_of);

} // namespace quell::examples
