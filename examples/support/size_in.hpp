#pragma once

#include <quell/image/extent.hpp>

#include <string>

namespace quell::examples {

/// What --size says, as in "1920x1080".
/// @param least of width and height, @param max_pixels of both together: twice those of 8K, whose channels take gigabytes
/// @throws Error for anything else
[[nodiscard]] Extent size_in(std::string const& text, int least = 1, long long max_pixels = 1LL << 26);

} // namespace quell::examples
