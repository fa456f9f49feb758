#pragma once

#include <quell/core/half_pack.hpp>
#include <quell/image/image_storage.hpp>

/// @file
/// Packs of pixels of one row, or of two: those of an even row, and those below them.

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Row of the second half of a pack. There is none where `rows` is 1.
template <int rows> struct SecondRow {
    static constexpr int y = 0;
    static constexpr bool inside = false;
    QUELL_KERNEL explicit SecondRow(int) {}
    QUELL_KERNEL SecondRow at(int, int) const { return *this; }
};
template <> struct SecondRow<2> {
    int y;              ///< row
    bool inside = true; ///< false where at() left the image; y is then the border's row
    QUELL_KERNEL explicit SecondRow(int row, bool is_inside = true) : y(row), inside(is_inside) {}
    /// The row `dy` below, in an image whose last row is `last`.
    QUELL_KERNEL SecondRow at(int dy, int last) const { return SecondRow(clamp_to(y + dy, last), inside && y + dy >= 0 && y + dy <= last); }
};

/// A number for each row, in the lanes of that row.
template <class Real, int rows> QUELL_KERNEL Real by_rows(float first, [[maybe_unused]] float second) {
    if constexpr (rows == 1)
        return Real(first);
    else
        return joined_halves<Real>(typename HalfPack<Real>::type(first), typename HalfPack<Real>::type(second));
}
template <class Real, int rows> QUELL_KERNEL auto load_rows(auto const& view, int x, int y, [[maybe_unused]] SecondRow<rows> second) {
    if constexpr (rows == 1)
        return load_pixels<Real>(view, x, y);
    else {
        using Half = typename HalfPack<Real>::type;
        return map([](auto above, auto below) QUELL_INLINED { return joined_halves<Real>(above, below); }, load_pixels<Half>(view, x, y),
                   load_pixels<Half>(view, x, second.y));
    }
}
/// Stores the first `count` lanes of each row.
template <class Real, int rows> QUELL_KERNEL void store_rows(auto const& view, int x, int y, auto const& value, int count) {
    if constexpr (rows == 1)
        store_pixels<Real>(view, x, y, value, count);
    else {
        using Half = typename HalfPack<Real>::type;
        store_pixels<Half>(view, x, y, map([](auto a) QUELL_INLINED { return first_half(a); }, value), count);
        store_pixels<Half>(view, x, y + 1, map([](auto a) QUELL_INLINED { return second_half(a); }, value), count);
    }
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
