#pragma once

#include <quell/frame/cursor/pixel.hpp>

namespace quell {

/// The pixel that a point of the image's plane lies in, however far outside the image that is.
/// @tparam Px the cursor that looks there
template <class Px> struct PixelUnder {
    using Real = typename Px::Real;
    Real column, row;
    decltype(column < row) inside; ///< whether the image has it
    PastPlace<Real> place;         ///< for `elsewhere` and `signal_elsewhere`, which may be asked for no more than a pixel outside

    QUELL_KERNEL PixelUnder(Px const& px, vec2<Real> const& point)
        : column(floor(point.x)), row(floor(point.y)),
          inside(both(column >= Real(0.f), column < width(px), row >= Real(0.f), row < height(px))),
          place(clamp(column, Real(-1.f), width(px)), clamp(row, Real(-1.f), height(px))) {}

private:
    QUELL_KERNEL static Real width(Px const& px) { return Real(static_cast<float>(px.size().width)); }
    QUELL_KERNEL static Real height(Px const& px) { return Real(static_cast<float>(px.size().height)); }
};

} // namespace quell
