#pragma once

#include <quell/diagnose/debug_channels.hpp>

#include <filesystem>
#include <string>

namespace quell::examples {

/// Names of the channels in DebugChannels, with commas between them.
[[nodiscard]] std::string debug_view_names();
[[nodiscard]] bool is_debug_view(std::string const& name);

/// The path of a file beside an output file: for out.0004.exr or out.0004, out.0004.NAME.
[[nodiscard]] std::filesystem::path path_beside(std::filesystem::path output, std::string const& name);

/// Writes the image beside an output file: for out.0004.exr or out.0004, out.0004.NAME.exr with its numbers in channel Y, and
/// out.0004.NAME.png to look at: history length and clamp from black (0) to white (32 frames, and 1), motion source and rejection in a
/// colour for each value (black for 0, then red, green, blue, yellow, magenta, cyan, white).
/// @throws Error naming the file
void write_debug_view(std::filesystem::path const& output, std::string const& view, std::string const& name, DebugImage const& image);

} // namespace quell::examples
