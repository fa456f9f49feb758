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
    auto const along = [&](int lines, int length, std::size_t line_step, std::size_t step) {
        std::vector<double> before(static_cast<std::size_t>(length) + 1);
        for (int line = 0; line < lines; ++line) {
            auto const first = static_cast<std::size_t>(line) * line_step;
            before[0] = 0;
            for (std::size_t i = 0; i < static_cast<std::size_t>(length); ++i) before[i + 1] = before[i] + values[first + i * step];
            for (int i = 0; i < length; ++i) {
                auto const low = static_cast<std::size_t>(std::max(i - radius, 0)),
                           high = static_cast<std::size_t>(std::min(i + radius + 1, length));
                values[first + static_cast<std::size_t>(i) * step] = before[high] - before[low];
            }
        }
    };
    auto const width = static_cast<std::size_t>(size.width);
    along(size.height, size.width, width, 1), along(size.width, size.height, 1, width);
}

} // namespace quell::inline QUELL_INSTRUCTION_SET
