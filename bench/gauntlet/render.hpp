#pragma once

#include <gauntlet/shot.hpp>

#include <cstdint>
#include <vector>

namespace quell::gauntlet {

/// What a pixel has, as Cycles' passes do: sums and means over its samples.
struct Pixel {
    Vec3 diffuse_colour{0.}, direct{0.}, indirect{0.}; ///< light times colour
    Vec3 gloss_colour{0.}, gloss{0.};
    Vec3 clear_colour{0.}, clear{0.};
    Vec3 volume{0.}, glow{0.}, sky{0.};
    double covered = 0, alpha = 0; ///< parts of it that show a thing, and that the film has
    double depth = 1e10;           ///< of the first sample, along the view's axis
    Vec3 normal{0.};
    Vec2 motion{0.}, motion_next{0.}; ///< in pixels, y down: other frame's place less this frame's
    double broken = 0;                ///< part of it that a situation breaks

    [[nodiscard]] Vec3 combined() const { return direct + indirect + gloss + clear + volume + glow + sky; }
};

struct Rendered {
    Extent size;
    std::vector<Pixel> pixels;

    [[nodiscard]] Pixel const& at(int x, int y) const { return pixels[static_cast<std::size_t>(y * size.width + x)]; }
    [[nodiscard]] Pixel& at(int x, int y) { return pixels[static_cast<std::size_t>(y * size.width + x)]; }
};

/// One frame with its noise.
[[nodiscard]] Rendered rendered(Shot const& shot, Making const& making, int frame);

/// What frames of that shot are without noise, with guides.
/// @param half  0 or 1: two references whose own errors have nothing to do with each other
[[nodiscard]] Rendered reference(Shot const& shot, Making const& making, int frame, int half = 0);

} // namespace quell::gauntlet
