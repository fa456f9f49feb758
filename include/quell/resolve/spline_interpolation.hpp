#pragma once

#include <quell/execute/executor.hpp>
#include <quell/frame/cursor/past_pixel.hpp>
#include <quell/frame/hull.hpp>
#include <quell/motion/catmull_rom.hpp>

/// Images at places between their pixels' centres.
namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Whole-numbered places of which taps from -1 to +2 are fetched. Where some lie outside the image, the border repeats.
template <class Real> struct TapsAround {
    PixelCoordinates<Real> place;
    Extent size;

    QUELL_KERNEL TapsAround(Extent size_, Real column, Real row) : place(column, row), size(size_) {
        if constexpr (width_of < Real >> 1) {
            auto const inside = both(column >= Real(1.f), column < Real(static_cast<float>(size.width - 2)), row >= Real(1.f),
                                     row < Real(static_cast<float>(size.height - 2)));
            // Only gathers repeat the border.
            if (!all(inside)) place.adjacent = place.near_by = false;
        }
    }
    template <class View> QUELL_KERNEL auto at(View const& view, int dx, int dy) const { return fetch<Real>(view, size, place, dx, dy); }
};

/// An image at any place, by a Catmull-Rom spline limited to what its taps hold.
/// @param where in pixels; a pixel's centre is at .5
template <class Real, class View> QUELL_KERNEL auto interpolate(View const& view, Extent size, vec2<Real> const& where) {
    using V = Value<View::components, Real>;
    auto const column = floor(where.x - 0.5f), row = floor(where.y - 0.5f);
    auto const across = catmull_rom_weights(where.x - 0.5f - column), down = catmull_rom_weights(where.y - 0.5f - row);
    TapsAround<Real> const taps(size, column, row);
    Hull<V> hull(V(taps.at(view, 0, 0)));
    auto sum = zero<V>();
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i) {
            V const tap = taps.at(view, i - 1, j - 1);
            sum = add_scaled(sum, tap, across.at[i] * down.at[j]);
            hull.add(tap);
        }
    return hull.limited(sum);
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
