#pragma once

#include <quell/core/real.hpp>

/// The halves of a checkerboard, 0 and 1: pixels of one hold samples that the other has not seen.
namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// The half of pixels of a column and row.
template <class Real> QUELL_KERNEL Real checkerboard_half(Real column, Real row) {
    auto const sum = column + row;
    return sum - 2.f * floor(sum * 0.5f);
}
/// That of a cursor's pixels.
template <class Px> QUELL_KERNEL auto checkerboard_half(Px const& px) { return checkerboard_half(px.columns(), px.row_of_lanes()); }

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
