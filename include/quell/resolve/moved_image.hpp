#pragma once

#include <quell/core/real.hpp>
#include <quell/resolve/planes.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// What an image of the frame before, or after, is where its surfaces are now, between its pixels.
/// @param image     colours of its pixels by their index, row by row
/// @param motion    a view of where each surface is in that frame, less where it is now, in pixels; not finite: unknown
/// @param elsewhere where they are not in the image
template <Executor E>
std::vector<glm::vec3> moved(E const& executor, auto const& image, ImageView auto motion, glm::vec3 const& elsewhere) {
    auto const size = motion.size;
    auto const width = static_cast<float>(size.width), height = static_cast<float>(size.height);
    std::vector<glm::vec3> now(static_cast<std::size_t>(size.pixels()));
    auto const at = [&](int x, int y) {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(x);
    };
    auto const value = [&](int x, int y) -> glm::vec3 {
        float const column = static_cast<float>(x) + motion.get(0, x, y), row = static_cast<float>(y) + motion.get(1, x, y);
        bool const inside = column > -0.5f && column < width - 0.5f && row > -0.5f && row < height - 0.5f;
        if (!is_finite(column) || !is_finite(row) || !inside) return elsewhere;
        float const left = std::floor(column), top = std::floor(row), right_part = column - left, lower_part = row - top;
        auto const row_at = [&](int down) {
            int const there = std::clamp(static_cast<int>(top) + down, 0, size.height - 1);
            auto const pixel = [&](int right) { return image[at(std::clamp(static_cast<int>(left) + right, 0, size.width - 1), there)]; };
            return (1.f - right_part) * pixel(0) + right_part * pixel(1);
        };
        return (1.f - lower_part) * row_at(0) + lower_part * row_at(1);
    };
    for_all_pixels(executor, size, [&]<class Real>(AtOnce<Real>, int x, int y, int count) {
        for (int i = x; i < x + count; ++i) now[at(i, y)] = value(i, y);
    });
    return now;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
