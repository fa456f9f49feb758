#pragma once

#include <quell/core/error.hpp>
#include <quell/io/exr_image.hpp>
#include <quell/metrics/picture.hpp>

#include <filesystem>
#include <fstream>
#include <string>

// What programs that measure do with files.
namespace quell::bench {

/// @throws Error where the file can't be written
inline void write_text(std::filesystem::path const& path, std::string const& text) {
    std::ofstream file(path, std::ios::binary);
    file << text;
    if (!file.flush()) throw Failure(path.string(), "it can't be written", "check the folder and the space that is left");
}

/// A word of a shell's command line, in quotes where it needs them.
inline std::string quoted(std::string const& text) {
    if (text.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789%+,-./:@_") == text.npos) return text;
    std::string result = "'";
    for (char const c : text) result += c == '\'' ? "'\\''" : std::string(1, c);
    return result + "'";
}

/// The picture of the planes R, G and B of a layer: a name with a dot behind it, or nothing.
inline metrics::Picture picture_in(io::ExrImage const& image, std::string const& layer) {
    metrics::Picture picture{image.size, {}};
    auto const &r = image[layer + "R"].values, &g = image[layer + "G"].values, &b = image[layer + "B"].values;
    for (std::size_t i = 0; i < r.size(); ++i) picture.pixels.emplace_back(r[i], g[i], b[i]);
    return picture;
}

} // namespace quell::bench
