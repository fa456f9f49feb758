#pragma once

#include <library/compiled_preset.hpp>

#include <quell/image/planar.hpp>
#include <quell/io/channel_names.hpp>
#include <quell/io/exr_image.hpp>

#include <span>
#include <string>
#include <vector>

namespace quell::examples {

using quell_library::ReadChannel;

/// The planes of a file that a channel is read from.
/// @throws Error where `names` has another number of components
[[nodiscard]] std::vector<std::string> planes_of(ReadChannel const& channel, io::ChannelNames const& names);

/// A frame that was read from a file, for a compiled preset.
class LoadedFrame {
    std::vector<Planar<>::Image<1>> planes; ///< of all channels, one after the other

public:
    quell_library::FrameImages images; ///< they lie in `planes`

    /// Fills all channels. One that is optional has no data where the file has not all of its planes.
    /// @throws Error naming the file and the channel that is missing or of a wrong type
    void load(std::span<ReadChannel const> channels, io::ExrImage const& image, io::ChannelNames const& names, long long number);
};

} // namespace quell::examples
