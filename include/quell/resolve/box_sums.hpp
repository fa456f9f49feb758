#pragma once

#include <quell/image/extent.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Replaces each value of an image, row by row, by the sum over the square around it, as far as that lies in the image.
/// @param size   of the image
/// @param values one for each pixel
/// @param radius of the square, in pixels: its side is 2 radius + 1
inline void box_sums(Extent size, std::vector<double>& values, int radius) {
    auto const width = static_cast<std::size_t>(size.width), height = static_cast<std::size_t>(size.height);
    auto const reach = static_cast<std::size_t>(std::max(radius, 0));
    auto const low = [&](std::size_t i) { return i - std::min(i, reach); };
    std::vector<double> before(width + 1); // the sum of what is left of each pixel
    for (std::size_t y = 0; y < height; ++y) {
        double* const row = values.data() + y * width;
        for (std::size_t x = 0; x < width; ++x) before[x + 1] = before[x] + row[x];
        for (std::size_t x = 0; x < width; ++x) row[x] = before[std::min(x + reach + 1, width)] - before[low(x)];
    }
    constexpr std::size_t most = 32; // columns at once, so that rows are read as they lie in memory
    std::vector<double> above((height + 1) * std::min(most, width));
    for (std::size_t x = 0; x < width; x += most) {
        auto const columns = std::min(most, width - x);
        auto const sums = [&](std::size_t y) { return above.data() + y * columns; };
        std::fill_n(sums(0), columns, 0.);
        for (std::size_t y = 0; y < height; ++y)
            for (std::size_t i = 0; i < columns; ++i) sums(y + 1)[i] = sums(y)[i] + values[y * width + x + i];
        for (std::size_t y = 0; y < height; ++y) {
            auto const *const end = sums(std::min(y + reach + 1, height)), *const begin = sums(low(y));
            for (std::size_t i = 0; i < columns; ++i) values[y * width + x + i] = end[i] - begin[i];
        }
    }
}

} // namespace quell::inline QUELL_INSTRUCTION_SET
