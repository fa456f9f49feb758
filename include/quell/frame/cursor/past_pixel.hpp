#pragma once

#include <quell/core/permute.hpp>
#include <quell/frame/cursor/scope.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Whole-numbered pixel coordinates in the previous frame, one pixel for each lane, at most one pixel outside the image. With a still or
/// panning camera most packs land on adjacent pixels of one row: one load per component then replaces a gather. With any smooth motion they
/// land within a window of two rows, twice as wide as a pack: loads and permutations replace the gather.
template <class Real> struct PixelCoordinates {
    Real column,           ///< whole number
        row;               ///< whole number
    int x = 0,             ///< first column of the lanes' window; packs only
        y = 0;             ///< first row of it; packs only
    bool adjacent = false, ///< the lanes are adjacent pixels of one row, from (x, y) on; packs only
        near_by = false;   ///< the lanes are in columns x to x + 2 width_of<Real> - 1 of rows y and y + 1; packs only

    /// Of whole numbers. Finds out how the lanes lie.
    QUELL_KERNEL PixelCoordinates(Real column_, Real row_) : column(column_), row(row_) {
        if constexpr (width_of < Real >> 1) {
            constexpr int last = width_of<Real> - 1;
            auto const columns = truncate(column), rows = truncate(row);
            x = lane(columns, 0), y = lane(rows, 0);
            auto const expected = Real(static_cast<float>(x)) + lanes<Real>();
            adjacent = !any(abs(column - expected) + abs(row - static_cast<float>(y)) > Real(0.5f));
            if constexpr (detail::permutes<Real>)
                if (!adjacent) {
                    // Smooth motion keeps the order of the lanes, up to rounding.
                    x = (x < lane(columns, last) ? x : lane(columns, last)) - 1;
                    y = y < lane(rows, last) ? y : lane(rows, last);
                    near_by = all(both(in_window() >= Real(0.f), in_window() < Real(2.f * width_of<Real>),
                                       row >= Real(static_cast<float>(y)), row <= Real(static_cast<float>(y + 1))));
                }
        }
    }
    /// Columns from the window's first one.
    QUELL_KERNEL Real in_window() const { return column - static_cast<float>(x); }
};

namespace detail {
/// The pixel at a whole-numbered column and row; outside an image of `size` the nearest one.
template <class Real> QUELL_KERNEL PixelCoordinates<Real> nearest_inside(Extent size, vec2<Real> const& at) {
    return {clamp(at.x, Real(0.f), Real(static_cast<float>(size.width - 1))),
            clamp(at.y, Real(0.f), Real(static_cast<float>(size.height - 1)))};
}
} // namespace detail

/// The pixel that contains `where` (pixel coordinates); outside the image the nearest one.
template <class Px, class Real> QUELL_KERNEL PixelCoordinates<Real> nearest_place(Px const& px, vec2<Real> const& where) {
    return detail::nearest_inside(px.size(), vec2<Real>{floor(where.x), floor(where.y)});
}

namespace detail {
/// Whether a view loads packs from a row at the cost of one load per component.
template <class View, class Real> inline constexpr bool loads_rows = permutes<Real>&& requires(View view) {
    view.template load_component<Real>(0, 0, 0);
};

/// Pixels of a view at a place whose lanes are `near_by`, plus (dx, dy).
template <class Real, class View> QUELL_KERNEL auto permute_pixels(View const& view, PixelCoordinates<Real> const& place, int dx, int dy) {
    constexpr int width = width_of<Real>;
    auto const at = truncate(place.in_window());
    auto const start = [&](int x) QUELL_INLINED { return x < -width ? -width : x > view.size.width ? view.size.width : x; };
    int const first = start(place.x + dx), second = start(place.x + dx + width);
    auto const row = [&](int y) QUELL_INLINED {
        int const inside = clamp_to(y, view.size.height - 1);
        return map([&](auto low, auto high) QUELL_INLINED { return permuted(low, high, at); }, load_pixels<Real>(view, first, inside),
                   load_pixels<Real>(view, second, inside));
    };
    auto const upper = row(place.y + dy);
    auto const below = place.row > Real(static_cast<float>(place.y));
    return any(below) ? select(below, row(place.y + dy + 1), upper) : upper;
}

/// Pixels of a view of `size` at a place plus (dx, dy). Outside the image: lanes of a gather repeat the border, lanes of a load are finite
/// and without meaning.
template <class Real, class View> QUELL_KERNEL auto fetch(View view, Extent size, PixelCoordinates<Real> const& place, int dx, int dy) {
    view.size = size;
    if (place.adjacent) return load_pixels<Real>(view, place.x + dx, clamp_to(place.y + dy, size.height - 1));
    if constexpr (loads_rows<View, Real>)
        if (place.near_by) return permute_pixels<Real>(view, place, dx, dy);
    Real const last_column(static_cast<float>(size.width - 1)), last_row(static_cast<float>(size.height - 1));
    return gather_pixels<Real>(view, truncate(clamp(place.column + static_cast<float>(dx), Real(0.f), last_column)),
                               truncate(clamp(place.row + static_cast<float>(dy), Real(0.f), last_row)));
}
/// Pixels of a view at whole-numbered columns and rows. Outside the image the border repeats.
template <class Real, class View> QUELL_KERNEL auto fetch_repeated(View const& view, vec2<Real> const& at) {
    return fetch<Real>(view, view.size, nearest_inside(view.size, at), 0, 0);
}
} // namespace detail

/// The cursor at a pixel of the previous frame: its remembered channels, its kept channels and its signal.
/// @tparam Real float or a pack
/// @tparam S    the Scope
template <class Real, class S> struct PastPixel {
    S const& scope;                      ///< of the pass
    PixelCoordinates<Real> const& place; ///< a reference: g++ copies 16 bytes at a time and then stalls on the stores
    int dx,                              ///< columns from the place
        dy;                              ///< rows from the place

    /// True where the pixel lies inside the image.
    QUELL_KERNEL auto inside() const {
        auto const column = place.column + static_cast<float>(dx), row = place.row + static_cast<float>(dy);
        return both(column >= Real(0.f), column < Real(static_cast<float>(scope.size.width)), row >= Real(0.f),
                    row < Real(static_cast<float>(scope.size.height)));
    }
    /// Pixel coordinates of its sample in the previous frame: the centre plus that frame's jitter.
    QUELL_KERNEL vec2<Real> sample_position() const {
        return {place.column + (static_cast<float>(dx) + 0.5f + scope.jitter_then.x),
                place.row + (static_cast<float>(dy) + 0.5f + scope.jitter_then.y)};
    }

    /// The value of a remembered or kept channel.
    template <ChannelTag C> QUELL_KERNEL auto operator[](C c) const {
        constexpr bool remembered = S::remembered_channels::template has<C>, kept = S::kept_channels::template has<C>;
        static_assert(remembered || kept,
                      "a policy looks at the previous frame's channel that it does not list: add it to `remembers` or `keeps`");
        if constexpr (remembered)
            return detail::Remembered<C>::unpack(fetch(scope.remembered.view(typename detail::Remembered<C>::Stored{})));
        else if constexpr (kept)
            return fetch(scope.kept_then.view(c));
    }
    /// The signal that history holds.
    QUELL_KERNEL auto signal() const {
        static_assert(S::reads_past_signal, "a filter looks at the signal of the last frame without saying so: add `static constexpr bool "
                                            "reads_past_signal = true` to it");
        return fetch(scope.signal_then);
    }

private:
    QUELL_KERNEL auto fetch(auto const& view) const { return detail::fetch<Real>(view, scope.size, place, dx, dy); }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
