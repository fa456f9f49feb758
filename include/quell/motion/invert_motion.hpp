#pragma once

#include <quell/core/error.hpp>
#include <quell/core/real.hpp>
#include <quell/image/image_storage.hpp>

#include <cstdint>
#include <limits>
#include <math.h>
#include <vector>

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {
/// Splats the inverted motion of every pixel of the next frame to those pixels within `reach` (pixels, in x and y) of its previous position
/// that are not taken yet.
template <ImageView To, ImageView NextMotion, ImageView NextDepth>
void splat_motion(To const& to, NextMotion const& next_motion, NextDepth const& next_depth, float reach, std::vector<std::uint8_t>& taken) {
    auto const width = static_cast<std::size_t>(to.size.width);
    struct Offer {
        float depth = std::numeric_limits<float>::infinity(), distance = 4.f;
    };
    std::vector<Offer> best(taken.size());
    auto const offer = [&](int x, int y, float dx, float dy, Offer const& now) {
        auto const i = static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x);
        if (taken[i] == 1) return;
        auto& so_far = best[i];
        // Of one surface the closest to the pixel's centre wins; of two surfaces the one in front.
        bool const in_front = now.depth < so_far.depth * 0.95f,
                   same = now.depth <= so_far.depth * 1.05f || (!is_finite(now.depth) && !is_finite(so_far.depth));
        if (!in_front && !(same && now.distance < so_far.distance)) return;
        so_far = now;
        to.set(0, x, y, dx), to.set(1, x, y, dy);
    };
    for (int y = 0; y < to.size.height; ++y)
        for (int x = 0; x < to.size.width; ++x) {
            float const dx = next_motion.get(0, x, y), dy = next_motion.get(1, x, y), z = next_depth.get(0, x, y);
            if (!is_finite(dx) || !is_finite(dy) || abs(dx) > 1e6f || abs(dy) > 1e6f) continue;
            float const u = static_cast<float>(x) + dx, v = static_cast<float>(y) + dy;
            int const left = static_cast<int>(::floorf(u)), top = static_cast<int>(::floorf(v));
            for (int j = 0; j < 2; ++j)
                for (int i = 0; i < 2; ++i) {
                    int const column = left + i, row = top + j;
                    float const off_x = abs(u - static_cast<float>(column)), off_y = abs(v - static_cast<float>(row));
                    bool const inside = column >= 0 && row >= 0 && column < to.size.width && row < to.size.height;
                    if (inside && off_x <= reach && off_y <= reach) offer(column, row, -dx, -dy, {z, off_x * off_x + off_y * off_y});
                }
        }
    for (std::size_t i = 0; i < taken.size(); ++i)
        if (best[i].distance < 4.f) taken[i] = 1;
}
} // namespace detail

/// Makes motion_next for renderers that do not supply it, by inverting the next frame's motion. Each pixel of the next frame is splatted to
/// its position in this frame; the nearest to the camera wins. Pixels that nothing reaches (hidden in the next frame) become NaN: they have
/// no history from that side.
/// @param to          this frame's motion_next, written
/// @param next_motion the next frame's Motion, in pixels, y down
/// @param next_depth  the next frame's Depth
/// @throws Error where the three sizes differ
template <ImageView To, ImageView NextMotion, ImageView NextDepth>
void invert_motion(To const& to, NextMotion const& next_motion, NextDepth const& next_depth) {
    static_assert(To::components == 2 && NextMotion::components == 2 && NextDepth::components == 1,
                  "invert_motion(to, next_motion, next_depth): motion has two components and depth has one");
    if (!(to.size == next_motion.size && to.size == next_depth.size))
        raise_error<Failure>("invert_motion",
                             "`to` of " + to_string(to.size) + ", motion of " + to_string(next_motion.size) + " and depth of " +
                                 to_string(next_depth.size),
                             "give images of one size");
    auto const nowhere = std::numeric_limits<float>::quiet_NaN();
    for (int y = 0; y < to.size.height; ++y)
        for (int x = 0; x < to.size.width; ++x) to.set(0, x, y, nowhere), to.set(1, x, y, nowhere);
    // First what falls into a pixel. Then, for gaps where surfaces are magnified in this frame, what falls within one pixel.
    std::vector<std::uint8_t> taken(static_cast<std::size_t>(to.size.pixels()), 0);
    for (float const reach : {0.5f, 0.99f}) detail::splat_motion(to, next_motion, next_depth, reach, taken);
}

} // namespace quell::inline QUELL_INSTRUCTION_SET
