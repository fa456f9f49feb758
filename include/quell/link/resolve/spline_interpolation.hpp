#pragma once

#include <quell/frame/cursor/past_pixel.hpp>
#include <quell/frame/hull.hpp>
#include <quell/motion/catmull_rom.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// A place of which taps from -1 to +2 are fetched. Where some lie outside the image, the border repeats.
/// @param image  has the image's size()
/// @param column a whole number
/// @param row    a whole number
template <class Real> QUELL_KERNEL PixelCoordinates<Real> place_of_taps(auto const& image, Real const& column, Real const& row) {
    PixelCoordinates<Real> place(column, row);
    if constexpr (width_of < Real >> 1) {
        auto const size = image.size();
        auto const inside = both(column >= Real(1.f), column < Real(static_cast<float>(size.width - 2)), row >= Real(1.f),
                                 row < Real(static_cast<float>(size.height - 2)));
        // Only gathers repeat the border.
        if (!all(inside)) place.adjacent = place.near_by = false;
    }
    return place;
}

/// A picture at any place, by a Catmull-Rom spline limited to what its taps hold.
/// @param image has size() and picture(place, dx, dy)
/// @param where in pixels; a pixel's centre is at .5
template <class Real> QUELL_KERNEL auto interpolate(auto const& image, vec2<Real> const& where) {
    auto const column = floor(where.x - 0.5f), row = floor(where.y - 0.5f);
    auto const across = catmull_rom_weights(where.x - 0.5f - column), down = catmull_rom_weights(where.y - 0.5f - row);
    auto const place = place_of_taps(image, column, row);
    auto const middle = image.picture(place, 0, 0);
    using V = std::remove_const_t<decltype(middle)>;
    Hull<V> hull(middle);
    auto sum = zero<V>();
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i) {
            V const tap = image.picture(place, i - 1, j - 1);
            sum = add_scaled(sum, tap, across.at[i] * down.at[j]);
            hull.add(tap);
        }
    return hull.limited(sum);
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
