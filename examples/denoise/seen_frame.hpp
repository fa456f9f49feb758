#pragma once

#include <denoise/anti_alias.hpp>
#include <denoise/guide_images.hpp>
#include <denoise/light_split.hpp>

#include <quell/io/exr_image.hpp>
#include <quell/io/sequence_names.hpp>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace quell::examples {

/// What a pixel of a transparent film shows, as bits.
using FilmContent = unsigned char;
inline constexpr FilmContent shows_light = 1, shows_alpha = 2;
using FilmContents = std::vector<FilmContent>; ///< of all pixels

/// A frame that was read, and what is known of it by itself.
struct SeenFrame {
    long long number;
    io::ExrImage image;
    bool as_one;                                   ///< whether it is better filtered as one picture
    std::array<std::optional<LightSplit>, 2> ways; ///< its light by signals, and as one: where it was wanted
    std::shared_ptr<FrameAround const> around;     ///< what frames around it see
    GuideImages guides{};                          ///< those of its planes that were decoded
    bool has_noisy_guides = false;                 ///< so that the picture as one has less noise than its signals
    bool is_opaque = true;                       ///< whether the film is: else alpha is filtered as its picture is, and nothing comes back
    FilmContents film{};                         ///< what each pixel shows; empty where the film is opaque
    int samples = 0;                             ///< of each pixel, as believed; 0: the file doesn't say
    int said_samples = 0;                        ///< as the file says
    bool is_next_told = false;                   ///< whether untold motion to the next frame is among its vectors
    std::optional<io::SequenceNames> behind{};   ///< by which it is read where it is seen through a volume
    std::optional<io::SequenceNames> believed{}; ///< by which it is read where some albedo is not believed; goes before the other

    /// One of its guides; null where the file lacks it.
    [[nodiscard]] LoadedChannelPointer guide(auto channel, io::ChannelNames const& names) { return guides.get(channel.name, image, names); }
};

} // namespace quell::examples
