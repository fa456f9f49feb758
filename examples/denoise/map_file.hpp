#pragma once

#include <quell/io/exr_file.hpp>
#include <quell/io/file_views.hpp>

#include <string>
#include <string_view>

namespace quell::examples {

/// A map with every member. docs/programs.md says what they mean.
inline constexpr std::string_view map_example =
    R"({"channels":  {"depth": {"first_of": ["Z", "depth.Z"]}, "motion": ["speed.x", {"from": "speed.y", "scale": -1}],
               "normal": {"from": "N", "scale": 2, "offset": -1}},
 "motion":    {"points": "to_previous", "unit": "pixel", "y": "down", "jitter": "left_out"},
 "depth":     {"along": "view_axis"},
 "miss_from": 1e9,
 "miss_to":   0,
 "shutter":   0.5,
 "signals":   [{"radiance": "beauty", "albedo": "base_color"},
               {"irradiance": {"from": ["diffuse_direct", "diffuse_indirect"]}, "albedo": "diffuse_color"}],
 "added":     "emission",
 "picture":   "beauty"})";

/// Reads a channel map, by which quell-denoise understands any renderer's files: a JSON object such as map_example. What it leaves out goes
/// by quell's own names.
/// @param map a file, or else the name of a renderer's map that comes with the program
/// @param frame that the names are for: it decides between names that stand for each other, and which part's they are; null: the first
/// @throws Error naming the file, the member, and what to write
[[nodiscard]] io::SequenceNames read_map(std::string const& map, io::ExrListing const* frame = nullptr);

/// The same from text; `name` is what messages call it.
[[nodiscard]] io::SequenceNames parse_map(std::string const& text, std::string const& name, io::ExrListing const* frame = nullptr);

/// The views of a frame by a map, or where that is empty, as recognised. Each has names of its own. None where the frame is one.
/// @throws Error as read_map does
[[nodiscard]] io::FileViews views_in(io::ExrListing const& frame, std::string const& map = {});

/// The names by which a frame has what a view's names say, or the view of a signal.
[[nodiscard]] io::SequenceNames names_in_file(io::FileView const& view, io::ExrListing const& frame);

/// Recognises a frame, of several views the first, by its channels' names: as one of the renderers that there is a map of, where the names
/// leave no doubt, else as quell's own or Blender's.
/// @throws Error naming the file and its channels
[[nodiscard]] io::SequenceNames recognised(io::ExrListing const& frame);

} // namespace quell::examples
