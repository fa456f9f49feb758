#pragma once

#include <quell/core/real.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Natural logarithm of a positive normal number, with an error under 2e-7 of it or of 1. float and pack use the same instructions, without
/// libm. The mantissa m lies in [sqrt(1/2), sqrt(2)]; log m = 2 artanh((m - 1) / (m + 1)), whose series is taken to its ninth power.
template <class Real> QUELL_KERNEL Real logarithm(Real a) {
    auto const root_of_half = Index<Real>(0x3f3504f3);
    auto const above = bits(a) - root_of_half;
    auto const m = from_bits((above & Index<Real>(0x007fffff)) + root_of_half);
    auto const s = (m - 1.f) / (m + 1.f), square = s * s;
    auto p = fma(square, Real(2.f / 9.f), Real(2.f / 7.f));
    p = fma(square, p, Real(2.f / 5.f));
    p = fma(square, p, Real(2.f / 3.f));
    p = fma(square, p, Real(2.f));
    return fma(to_real(above >> 23), Real(0.693147181f), s * p);
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
