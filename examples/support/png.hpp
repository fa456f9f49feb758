#pragma once

#include <quell/metrics/picture.hpp>

#include <filesystem>
#include <vector>

namespace quell::examples {

/// Writes a displayed picture as 8-bit sRGB; the file appears whole or not at all. Throws quell::Error naming the file.
void write_png(std::filesystem::path const& path, metrics::Picture const& displayed);

/// The bytes of that file.
[[nodiscard]] std::vector<unsigned char> encode_png(metrics::Picture const& displayed);

} // namespace quell::examples
