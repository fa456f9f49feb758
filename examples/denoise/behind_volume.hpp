#pragma once

#include <quell/io/sequence_names.hpp>

#include <optional>

namespace quell::examples {

/// The name of the signal that is light in a volume; it has no factor.
inline constexpr auto volume_name = "volume";

/// What lies behind a volume, such as fog. A ray that was scattered before it hit a surface knows no depth, normal, motion or colour, and
/// of several samples some were. So guides are full of holes, which say nothing of the picture. This makes planes in which they have none:
///
/// - A pixel without a surface takes depth, normal, motion and colours from one beside it: from the one of middle depth, as far as two
///   pixels away. Where there is none it is a plane far behind everything.
/// - Colours are those of the samples that hit: divided by their part of all, which is the length of the mean normal. Light is multiplied
///   by that part instead. It is then light that comes through the volume: smoother than colours with holes, and filtered.
/// - What shines and what lies behind everything is seen through the volume too: it joins the light in it.
///
/// Each signal times its colour stays what it was. Pixels without light of a volume in the 5x5 around them stay as they are.
/// @param image the frame; planes are added to it, whose names begin with "quell:"
/// @param names of the files
/// @return the names of the frame as seen through its volume; none where it has no light in a volume, or no depth or normal
[[nodiscard]] std::optional<io::SequenceNames> names_behind_volume(io::ExrImage& image, io::SequenceNames const& names);

} // namespace quell::examples
