#pragma once

#include <quell/frame/cursor/pixel.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// The pixel that contains a point of the image plane. The point may lie outside the image.
/// @tparam Px the cursor that looks there
template <class Px> struct PixelUnder {
    /// float, or a pack of floats.
    using Real = typename Px::Real;
    /// Its pixel coordinates: whole numbers, not clamped.
    Real column, row;
    decltype(column < row) inside; ///< whether the pixel is in the image
    PixelCoordinates<Real>
        place; ///< argument of `elsewhere` and `signal_elsewhere`: the pixel clamped to at most one pixel outside the image

    /// @param px the pixel from which to look
    /// @param point in pixels; a pixel's centre is at .5
    QUELL_KERNEL PixelUnder(Px const& px, vec2<Real> const& point)
        : column(floor(point.x)), row(floor(point.y)),
          inside(both(column >= Real(0.f), column < width(px), row >= Real(0.f), row < height(px))),
          place(clamp(column, Real(-1.f), width(px)), clamp(row, Real(-1.f), height(px))) {}

private:
    QUELL_KERNEL static Real width(Px const& px) { return Real(to_real(px.size().width)); }
    QUELL_KERNEL static Real height(Px const& px) { return Real(to_real(px.size().height)); }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
