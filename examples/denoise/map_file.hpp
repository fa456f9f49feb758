#pragma once

#include <quell/io/sequence_names.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace quell::examples {

/// A map with every member. docs/programs.md says what they mean.
inline constexpr std::string_view map_example =
    R"({"channels":  {"depth": "Z", "normal": "N", "motion": ["speed.x", {"from": "speed.y", "scale": -1}]},
 "motion":    {"points": "to_previous", "unit": "pixel", "y": "down", "jitter": "left_out"},
 "depth":     {"along": "view_axis"},
 "miss_from": 1e9,
 "shutter":   0.5,
 "signals":   [{"radiance": "beauty", "albedo": "base_color"},
               {"irradiance": {"from": ["diffuse_direct", "diffuse_indirect"]}, "albedo": "diffuse_color"}],
 "added":     "emission",
 "picture":   "beauty"})";

/// Reads a channel map, by which quell-denoise understands any renderer's files: a JSON object such as map_example. What it leaves out goes
/// by quell's own names.
/// @throws Error naming the file, the member, and what to write
[[nodiscard]] io::SequenceNames read_map(std::filesystem::path const& file);

/// The same from text; `name` is what messages call it.
[[nodiscard]] io::SequenceNames parse_map(std::string const& text, std::string const& name);

/// The layer that a map says the denoised picture goes to, where it says that.
/// @throws Error as read_map does
[[nodiscard]] std::optional<std::string> read_picture_layer(std::filesystem::path const& file);

} // namespace quell::examples
