#pragma once

#include <quell/core/random.hpp>
#include <quell/image/extent.hpp>

#include <glm/vec2.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Chooses the pixels that a host shades twice for GradientOf<Signal> (A-SVGF, Schied et al. 2018): one of each 3x3 stratum, another one in
/// each frame.
///
///     GradientSamples const chosen{size, frame_number};
///     if (chosen.has(x, y)) frame[GradientOf<Radiance>{}].set(x, y, GradientSamples::gradient(luminance now, luminance before));
///
/// Shade the surface point that the pixel sees twice, with the random numbers that the point had in the previous frame: in this frame's
/// scene and in the previous frame's scene. All other pixels hold 0, as do points that were not seen before.
struct GradientSamples {
    static constexpr int side = 3; ///< of a stratum, in pixels
    Extent size;                   ///< of the frame, in pixels
    std::int32_t frame = 0;        ///< the frame's number
    std::int32_t seed = 0;         ///< any number; another seed makes other choices

    /// The chosen pixel of the stratum in this column and row of strata. Strata cut off by the image's border have one too.
    [[nodiscard]] glm::ivec2 in_stratum(int column, int row) const {
        int const x = column * side, y = row * side;
        int const width = size.width - x < side ? size.width - x : side, height = size.height - y < side ? size.height - y : side;
        auto const bits = detail::random_bits(static_cast<float>(column), static_cast<float>(row), frame ^ detail::scrambled(seed)).first;
        auto const chosen = static_cast<int>(static_cast<std::uint32_t>(bits) % static_cast<std::uint32_t>(width * height));
        return {x + chosen % width, y + chosen / width};
    }
    /// Whether the pixel (x, y) is chosen.
    [[nodiscard]] bool has(int x, int y) const { return in_stratum(x / side, y / side) == glm::ivec2(x, y); }

    /// The value of GradientOf: the difference of two luminances, and the larger one.
    [[nodiscard]] static glm::vec2 gradient(float now, float before) { return {now - before, now > before ? now : before}; }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
