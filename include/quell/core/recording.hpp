#pragma once

#include <quell/core/instruction_set.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

// A kernel can also be run once over a Real that records what is done to it, in place of computing: quell/shader/record.hpp.

/// Whether a Real records. Then nothing can branch on it, nor on where its pixel lies.
template <class Real> inline constexpr bool records = false;
/// A Real that records.
template <class Real>
concept RecordingReal = records<Real>;

namespace detail {
template <class Real> struct CoordinateOf { using type = int; };
} // namespace detail

/// A column or a row of the cursor of a Real: int, but where a Real records an integer that is recorded as well.
template <class Real> using Coordinate = typename detail::CoordinateOf<Real>::type;

} // namespace quell::inline QUELL_INSTRUCTION_SET
