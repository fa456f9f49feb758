#pragma once

#include <quell/frame/cursor/scope.hpp>

namespace quell {

/// Whole-numbered coordinates in the previous frame, one for each lane, at most one pixel outside the image. Most packs land on neighbours
/// in one row (still or panning camera): then `together`, and one load a component serves instead of a gather.
template <class Real> struct PastPlace {
    Real column, row;
    int x = 0, y = 0; ///< of the first lane
    bool together = false;

    QUELL_KERNEL PastPlace(Real column_, Real row_) : column(column_), row(row_) {
        if constexpr (width_of < Real >> 1) {
            x = lane(truncate(column), 0), y = lane(truncate(row), 0);
            auto const expected = Real(static_cast<float>(x)) + lanes<Real>();
            together = !any(abs(column - expected) + abs(row - static_cast<float>(y)) > Real(0.5f));
        }
    }
};

namespace detail {
/// The values of a view at a place.
template <class Real, class View> QUELL_KERNEL auto fetch(View view, Extent size, PastPlace<Real> const& place, int dx, int dy) {
    view.size = size;
    if (place.together) return load_pixels<Real>(view, place.x + dx, clamp_to(place.y + dy, size.height - 1));
    Real const last_column(static_cast<float>(size.width - 1)), last_row(static_cast<float>(size.height - 1));
    return gather_pixels<Real>(view, truncate(clamp(place.column + static_cast<float>(dx), Real(0.f), last_column)),
                               truncate(clamp(place.row + static_cast<float>(dy), Real(0.f), last_row)));
}
} // namespace detail

/// A pixel of the previous frame: what it remembers, what was kept there, and its signal.
template <class Real, class S> struct PastPixel {
    S const& scope;
    PastPlace<Real> const& place; ///< not a copy: g++ makes those 16 bytes at a time and then waits for the stores
    int dx, dy;

    /// True where the image has such a pixel.
    QUELL_KERNEL auto inside() const {
        auto const column = place.column + static_cast<float>(dx), row = place.row + static_cast<float>(dy);
        return both(column >= Real(0.f), column < Real(static_cast<float>(scope.size.width)), row >= Real(0.f),
                    row < Real(static_cast<float>(scope.size.height)));
    }
    /// Where what it remembers was seen, in pixels.
    QUELL_KERNEL vec2<Real> sample_position() const {
        return {place.column + (static_cast<float>(dx) + 0.5f + scope.jitter_then.x),
                place.row + (static_cast<float>(dy) + 0.5f + scope.jitter_then.y)};
    }

    template <ChannelTag C> QUELL_KERNEL auto operator[](C c) const {
        constexpr bool remembered = S::remembered_channels::template has<C>, kept = S::kept_channels::template has<C>;
        static_assert(remembered || kept,
                      "a policy looks at the previous frame's channel that it does not list: add it to `remembers` or `keeps`");
        if constexpr (remembered)
            return detail::Remembered<C>::unpack(fetch(scope.remembered.view(typename detail::Remembered<C>::Stored{})));
        else if constexpr (kept)
            return fetch(scope.kept_then.view(c));
    }
    QUELL_KERNEL auto signal() const { return fetch(scope.signal_then); }

private:
    QUELL_KERNEL auto fetch(auto const& view) const { return detail::fetch<Real>(view, scope.size, place, dx, dy); }
};

} // namespace quell
