#pragma once

#include <quell/core/random.hpp>
#include <quell/image/extent.hpp>

#include <glm/vec2.hpp>

namespace quell {

/// Which pixels of a frame a host shades twice for GradientOf<Signal> (A-SVGF, Schied 2018): one of each 3x3, another one in each frame.
///     GradientSamples const chosen{size, frame_number};
///     if (chosen.has(x, y)) frame[GradientOf<Radiance>{}].set(x, y, GradientSamples::gradient(luminance now, luminance before));
/// Both are of the surface point that the pixel sees, shaded with the random numbers that the pixel had in the previous frame: once in the
/// scene as it is, once in the scene as it was then. All other pixels have 0, and so have those whose point was not seen before.
struct GradientSamples {
    static constexpr int side = 3; ///< of what one pixel speaks for
    Extent size;
    std::int32_t frame = 0; ///< its number
    std::int32_t seed = 0;  ///< of the host's own, for other choices

    /// The chosen pixel of the 3x3 in this column and row of them; those that the image cuts off have one as well.
    [[nodiscard]] glm::ivec2 in_stratum(int column, int row) const {
        int const x = column * side, y = row * side;
        int const width = size.width - x < side ? size.width - x : side, height = size.height - y < side ? size.height - y : side;
        auto const bits = detail::random_bits(static_cast<float>(column), static_cast<float>(row), frame ^ detail::scrambled(seed)).first;
        auto const chosen = static_cast<int>(static_cast<std::uint32_t>(bits) % static_cast<std::uint32_t>(width * height));
        return {x + chosen % width, y + chosen / width};
    }
    [[nodiscard]] bool has(int x, int y) const { return in_stratum(x / side, y / side) == glm::ivec2(x, y); }

    /// What GradientOf holds: how much more there is now, and how much there is.
    [[nodiscard]] static glm::vec2 gradient(float now, float before) { return {now - before, now > before ? now : before}; }
};

} // namespace quell
