#pragma once

#include <quell/blend/blend_policy.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Updates a variance of luminance over time (Welford 1962, in West's exponential form). E[x^2] - E[x]^2 would cancel at HDR magnitudes.
/// Where the host gives the variance among the samples of a frame, that is added.
/// @param before the variance so far
/// @param off    luminance of the new frame minus the mean so far
/// @param alpha  weight of the new frame
template <class Px> QUELL_KERNEL auto variance_over_time(Px const& px, auto before, auto off, auto alpha) {
    auto const between = (1.f - alpha) * (before + off * off * alpha);
    if constexpr (Px::knows_samples)
        return fma(px.variance_of_sample(), alpha, between);
    else
        return between;
}

/// Bessel's correction, n / (n - 1). The divisor is at least 1/2, so that n near 1 stays finite.
template <class Real> QUELL_KERNEL Real unbiased_variance(Real over_time, Real n) { return over_time * (n / max(n - 1.f, Real(0.5f))); }

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
