#pragma once

#include <quell/metrics/picture.hpp>

#include <filesystem>
#include <vector>

namespace quell::examples {

/// The picture in a PNG file of up to 8 bits a component, sRGB-encoded as stored, in [0, 1]. Grey becomes colour, what is transparent is
/// laid over black. Throws quell::Error naming the file.
[[nodiscard]] metrics::Picture read_png(std::filesystem::path const& path);

/// Writes a displayed picture as 8-bit sRGB; the file appears whole or not at all. Throws quell::Error naming the file.
void write_png(std::filesystem::path const& path, metrics::Picture const& displayed);

/// The bytes of that file.
[[nodiscard]] std::vector<unsigned char> encode_png(metrics::Picture const& displayed);

} // namespace quell::examples
