#pragma once

#include <quell/core/error.hpp>
#include <quell/image/extent.hpp>

#include <cstdio>
#include <string>

namespace quell::examples {

/// What --size says, as in "1920x1080".
/// @param least of width and height, @param max_pixels of both together: twice those of 8K, whose channels take gigabytes
/// @throws Error for anything else
[[nodiscard]] inline Extent size_in(std::string const& text, int least = 1, long long max_pixels = 1LL << 26) {
    Extent size;
    char behind = 0;
    bool const two = std::sscanf(text.c_str(), "%5dx%5d%c", &size.width, &size.height, &behind) == 2;
    if (two && size.width >= least && size.height >= least && size.pixels() <= max_pixels) return size;
    auto const each = least > 1 ? ", each at least " + std::to_string(least) : std::string();
    auto const together = size.pixels() > max_pixels ? ", at most " + std::to_string(max_pixels) + " together" : std::string();
    throw Error("--size", "'" + text + "'", "give width and height in pixels" + each + together + ", as in 1920x1080");
}

} // namespace quell::examples
