#pragma once

#include <denoise/map_file.hpp>
#include <denoise/sequence_denoiser.hpp>

#include <quell/io/exr/exr_copy.hpp>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace quell::examples {

/// Which layers of a frame are written.
class LayerChoice {
    std::vector<std::string> names;

public:
    /// Any of: all, picture, signals, guides, and names of layers, channels or parts. Empty: all.
    explicit LayerChoice(std::vector<std::string> names_) : names(std::move(names_)) {}

    [[nodiscard]] bool has_picture() const { return has("picture"); }
    [[nodiscard]] bool has_signals() const { return has("signals"); }
    /// Whether guides that were accumulated are written.
    [[nodiscard]] bool has_guides() const { return has("guides"); }
    [[nodiscard]] bool is_signals_only() const { return names == std::vector<std::string>{"signals"}; }
    /// Whether a channel of the input goes on into the output.
    [[nodiscard]] bool keeps(std::string const& part, std::string const& channel) const;
    /// @throws Error naming a layer that the file has not
    void check(io::ExrListing const& file) const;

private:
    [[nodiscard]] bool has(std::string const& word) const;
};

/// The names of three channels.
using ChannelTriple = std::array<std::string, 3>;

/// The only signal's own channels, where these are the picture as they are; all three the same where it has one component.
[[nodiscard]] std::optional<ChannelTriple> only_signal(io::SequenceNames const& names);
/// The part that new channels go to: that of the signal's light.
[[nodiscard]] int home_part(io::ExrListing const& file, io::SequenceNames const& names);
/// A name for a layer: dots would part it.
[[nodiscard]] std::string word_of(std::string name);

/// Where the denoised picture goes: the place of the noisy one. That is the only signal where that is the picture, else what the names say,
/// else R, G, B.
/// @param layer that takes their place, where there is one
[[nodiscard]] ChannelTriple picture_channels(io::SequenceNames const& names, std::optional<std::string> const& layer = std::nullopt);
/// Alpha of the picture, where the file has it.
[[nodiscard]] std::optional<std::string> alpha_plane(io::ExrListing const& file, io::SequenceNames const& names,
                                                     std::optional<std::string> const& layer = std::nullopt);
/// Where each denoised signal goes, times its factor: layers denoised_NAME. None where there is but one signal and nothing is added to it,
/// which is the picture.
/// @throws Error for two signals of one name
[[nodiscard]] std::vector<ChannelTriple> signal_channels(io::SequenceNames const& names);

/// Rounds the picture to the format of the file's, and changes the strongest signal of each pixel, by no more than that rounding and that
/// of sums, so that the signals in their order and then what is added in its order make up the picture: as floats, to the last bit, or to
/// that of the largest of them where some cancel each other.
/// @param type the picture's format in the file
void add_up_exactly(DenoisedFrame& frame, std::array<io::SampleType, 3> const& type);

/// Makes sure that the output's numbers can be written into the file's parts.
/// @throws Error where the tiles of one of them have several levels
void check_levels(io::ExrOriginal const& original, io::SequenceNames const& names, std::optional<std::string> const& picture_layer,
                  LayerChoice const& layers);

/// What the output of a frame has in place of the input's channels, or beside them.
/// @param layers must outlive the result
[[nodiscard]] io::ExrChanges changes_for(DenoisedFrame& frame, io::ExrListing const& file, io::SequenceNames const& names,
                                         std::optional<std::string> const& picture_layer, LayerChoice const& layers);

} // namespace quell::examples
