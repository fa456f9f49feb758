#include "size_in.hpp"

#include <quell/core/error.hpp>

#include <cstdio>

namespace quell::examples {

Extent size_in(std::string const& text, int least, long long max_pixels) {
    Extent size;
    char behind = 0;
    bool const two = std::sscanf(text.c_str(), "%5dx%5d%c", &size.width, &size.height, &behind) == 2;
    if (two && size.width >= least && size.height >= least && size.pixels() <= max_pixels) return size;
    auto const each = least > 1 ? ", each at least " + std::to_string(least) : std::string();
    auto const together = size.pixels() > max_pixels ? ", at most " + std::to_string(max_pixels) + " together" : std::string();
    throw Error("--size", "'" + text + "'", "give width and height in pixels" + each + together + ", as in 1920x1080");
}

} // namespace quell::examples
