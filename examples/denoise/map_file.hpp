#pragma once

#include <quell/io/sequence_names.hpp>

#include <filesystem>
#include <string>

namespace quell::examples {

/// Reads a channel map, by which quell-denoise understands any renderer's files. A JSON object of these members, all optional; what it
/// leaves out goes by quell's own names.
///
///     {
///       "channels": { "depth": "Z", "normal": "N", "motion": ["speed.x", {"from": "speed.y", "scale": -1}] },
///       "motion":   { "points": "to_previous", "unit": "pixel", "y": "down", "jitter": "left_out" },
///       "miss_from": 1e9,
///       "shutter":  0.5,
///       "signals":  [ { "radiance": "beauty", "albedo": "base_color" },
///                     { "irradiance": {"from": ["diffuse_direct", "diffuse_indirect"]}, "albedo": "diffuse_color" } ],
///       "added":    {"from": ["emission", "background"]}
///     }
///
/// "channels"  quell's channel names, each with a CHANNEL: what every signal's guides are
/// "motion"    what the vectors mean: "points" to_previous or from_previous, "unit" pixel, uv (1 is the image's size) or ndc (2 is),
///             "y" down or up, "jitter" left_out or left_in (then files need the attributes quell:jitter and quell:jitter_previous)
/// "miss_from" a depth of this or more means that there is no surface
/// "shutter"   the part of the frame time during which the shutter is open
/// "signals"   what is denoised, each by itself, and then added up. "radiance" holds the albedo, which is divided out and multiplied back
///             ("albedo": 1 for none); "irradiance" doesn't, and is multiplied by it at the end. A signal may have "name" and any of
///             "channels" of its own. Without "signals" there is one, the channel "radiance".
/// "added"     what has no noise and is added at the end
///
/// A CHANNEL is a layer's name, to which quell's component letters are appended (.R .G .B for colours, .X .Y .Z for vectors; a channel of
/// one component is named whole), or a list of one SOURCE per component, or a number: that value everywhere; or an object {"from": one
/// layer or a list that is added up, "scale": a number}. A SOURCE is the same for one component with whole names.
/// @throws Error naming the file, the member, and what to write
[[nodiscard]] io::SequenceNames read_map(std::filesystem::path const& file);

/// The same from text; `name` is what messages call it.
[[nodiscard]] io::SequenceNames parse_map(std::string const& text, std::string const& name);

} // namespace quell::examples
