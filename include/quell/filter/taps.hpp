#pragma once

#include <quell/frame/pixel.hpp>

namespace quell {

/// Calls `body(near, weight, dx, dy)` for every pixel of a (2 radius + 1)^2 neighbourhood whose taps stand `step` pixels apart; `near` is
/// the cursor there. `weight` is profile[|column|] * profile[|row|], and 0 outside the image: whatever a kernel sums with it is renormalised at
/// borders. Rows outside are skipped whole.
template <int radius, class Px, class Body>
QUELL_KERNEL void for_each_tap(Px const& px, int step, float const (&profile)[radius + 1], Body&& body) {
    using Real = typename Px::Real;
    Real across[2 * radius + 1];
    for (int i = -radius; i <= radius; ++i)
        across[i + radius] = select(px.at(i * step, 0).inside(), Real(profile[i < 0 ? -i : i]), Real(0.f));
    for (int j = -radius; j <= radius; ++j) {
        int const row = px.y + j * step;
        if (row < 0 || row >= px.size().height) continue;
        for (int i = -radius; i <= radius; ++i)
            body(px.at(i * step, j * step), across[i + radius] * profile[j < 0 ? -j : j], i * step, j * step);
    }
}

/// The same with equal weights of 1.
template <int radius, class Px, class Body>
QUELL_KERNEL void for_each_neighbour(Px const& px, Body&& body) {
    float ones[radius + 1];
    for (float& one : ones) one = 1.f;
    for_each_tap<radius>(px, 1, ones, body);
}

} // namespace quell
