#pragma once

#include <quell/frame/cursor/past_pixel.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Like load_pixels, of views without padding before a row too: the border repeats.
template <class Real> QUELL_KERNEL auto load_beside(auto const& view, int x, int y) {
    return fetch_repeated<Real>(view, vec2<Real>{Real(static_cast<float>(x)) + lanes<Real>(), Real(static_cast<float>(y))});
}

/// A pixel, or the pixels of a pack, which may lie outside the image.
template <class Real> struct PixelInImage {
    Extent size; ///< of the image
    int x, y;    ///< of the first lane

    [[nodiscard]] QUELL_KERNEL bool any_row_inside() const { return y >= 0 && y < size.height; }
    QUELL_KERNEL auto inside() const {
        auto const columns = Real(static_cast<float>(x)) + lanes<Real>();
        return both(columns >= Real(0.f), columns < Real(any_row_inside() ? static_cast<float>(size.width) : 0.f));
    }
    /// What a view of the image's size has there. Outside the image it is without meaning.
    QUELL_KERNEL auto load(auto const& view) const { return load_beside<Real>(view, x, y); }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
