#pragma once

#include "compiled_preset.hpp"

#include <quell/image/planar.hpp>
#include <quell/io/channel_names.hpp>
#include <quell/io/exr_image.hpp>

// Frames of files for compiled code: of the programs, libquell-exr and quell for Python.
namespace quell_library {

/// A channel, by its name, in files.
struct FileChannel {
    using Memory = quell::Planar<>::Image<1>; ///< of all components, one after the other

    std::string_view name;
    int components;
    /// The planes of a file that it is read from.
    /// @throws quell::Error where `names` has another number of components
    std::vector<std::string> (*planes)(quell::io::ChannelNames const& names);
    /// Reads it into memory, which is made as large as it must be.
    /// @throws quell::Error naming the file and the plane that is missing or of a wrong type
    Image (*load)(Memory& memory, quell::io::ExrImage const& image, quell::io::ChannelNames const& names);
};

/// All that files can hold.
[[nodiscard]] std::vector<FileChannel> const& file_channels();

/// Null where no file holds a channel of that name.
[[nodiscard]] FileChannel const* find_file_channel(std::string_view name);

/// The planes of a file that a channel is read from.
/// @throws quell::Error where `names` has another number of components, or where no file holds the channel
[[nodiscard]] std::vector<std::string> planes_of(ReadChannel const& channel, quell::io::ChannelNames const& names);

/// A frame that was read from a file, for a compiled preset.
class LoadedFrame {
    std::vector<FileChannel::Memory> planes;

public:
    FrameImages images; ///< they lie in `planes`

    /// Fills all channels. One that is optional has no data where the file has not all of its planes.
    /// @throws quell::Error naming the file and the channel that is missing or of a wrong type
    void load(std::span<ReadChannel const> channels, quell::io::ExrImage const& image, quell::io::ChannelNames const& names,
              std::optional<long long> number);
};

} // namespace quell_library
