#pragma once

#include <quell/io/exr/exr_copy.hpp>

namespace quell::examples {

/// Writes the new numbers of a file, and nothing else of it, at another size. Each part that has some is one of scan lines, whose data
/// window is its display window; that is scaled. Other attributes stay, but for jitter (samples lie at the pixels' centres now), previews,
/// and those of Cryptomatte, whose layers are not there. The file is replaced atomically.
/// A part in which a lossy compression would make bright colours infinite is packed without loss (ZIP).
/// @param changes whose canvas is the new size
/// @returns names of the parts that are packed without loss for that reason; a part's number where it has no name
/// @throws Failure naming the file where it can't be written
std::vector<std::string> write_upsampled(std::filesystem::path const& path, io::ExrOriginal const& original, io::ExrChanges const& changes);

} // namespace quell::examples
