#pragma once

#include <quell/blend/blend_policy.hpp>

namespace quell::detail {

/// The variance of a pixel's luminance over time, of which the newest frame weighs alpha and lies `off` from the mean before. Updated by
/// differences (Welford 1962, in West's exponential form): E[x^2] - E[x]^2 would cancel at HDR magnitudes. A frame of several samples
/// brings the variance among them, as far as the host knows it.
template <class Px> QUELL_KERNEL auto variance_over_time(Px const& px, auto before, auto off, auto alpha) {
    auto const between = (1.f - alpha) * (before + off * off * alpha);
    if constexpr (Px::knows_samples)
        return fma(px.variance_of_sample(), alpha, between);
    else
        return between;
}

/// The squares of n samples' distances from their own mean come out too small, by (n - 1) / n; under one and a half samples the divisor
/// stays at a half.
template <class Real> QUELL_KERNEL Real unbiased_variance(Real over_time, Real n) { return over_time * (n / max(n - 1.f, Real(0.5f))); }

} // namespace quell::detail
