#pragma once

#include <quell/frame/pixel.hpp>

namespace quell {

/// Calls `body(near, weight, dx, dy)` for every pixel of a (2 radius + 1)^2 neighbourhood whose taps stand `step` pixels apart; `near` is
/// the cursor there. `weight` is profile[|column|] * profile[|row|], and 0 outside the image: whatever a kernel sums with it is
/// renormalised at borders. Rows outside are skipped whole.
template <int radius, class Px, class Body>
QUELL_KERNEL void for_each_tap(Px const& px, int step, float const (&profile)[radius + 1], Body&& body) {
    using Real = typename Px::Real;
    // What depends on the column is worked out once, not once a row; unrolled, its addresses become constants of the row.
    constexpr auto columns = std::make_integer_sequence<int, 2 * radius + 1>{};
    Real across[2 * radius + 1];
    int column[2 * radius + 1];
    [&]<int... i>(std::integer_sequence<int, i...>) __attribute__((always_inline)) {
        ((across[i] = select(px.at((i - radius) * step, 0).inside(), Real(profile[i < radius ? radius - i : i - radius]), Real(0.f)),
          column[i] = px.at((i - radius) * step, 0).x),
         ...);
    }
    (columns);
    for (int j = -radius; j <= radius; ++j) {
        int const row = px.y + j * step;
        if (row < 0 || row >= px.size().height) continue;
        float const down = profile[j < 0 ? -j : j];
        [&]<int... i>(std::integer_sequence<int, i...>) __attribute__((always_inline)) {
            (body(Px{px.scope, column[i], row}, across[i] * down, (i - radius) * step, j * step), ...);
        }
        (columns);
    }
}

/// The same in opposite pairs and without the centre: `body(near, weight, opposite, its weight, dx, dy)`, so that what depends on the
/// distance alone is worked out once for two taps. Rows outside have weight 0. Unrolled: for small radii.
template <int radius, class Px, class Body>
QUELL_KERNEL void for_each_tap_pair(Px const& px, int step, float const (&profile)[radius + 1], Body&& body) {
    using Real = typename Px::Real;
    constexpr int side = 2 * radius + 1, pairs = side * side / 2;
    Real across[side];
    int column[side], row[side];
    float down[side];
    auto const prepare = [&](auto i) __attribute__((always_inline)) {
        auto const beside = px.at((i - radius) * step, 0), below = px.at(0, (i - radius) * step);
        float const weight = profile[i < radius ? radius - i : i - radius];
        across[i] = select(beside.inside(), Real(weight), Real(0.f));
        column[i] = beside.x;
        down[i] = below.row_inside ? weight : 0.f;
        row[i] = below.y;
    };
    [&]<int... i>(std::integer_sequence<int, i...>) __attribute__((always_inline)) { (prepare(std::integral_constant<int, i>{}), ...); }
    (std::make_integer_sequence<int, side>{});
    [&]<int... k>(std::integer_sequence<int, k...>) __attribute__((always_inline)) {
        constexpr int last = side * side - 1;
        (body(Px{px.scope, column[k % side], row[k / side]}, across[k % side] * down[k / side],
              Px{px.scope, column[(last - k) % side], row[(last - k) / side]}, across[(last - k) % side] * down[(last - k) / side],
              (k % side - radius) * step, (k / side - radius) * step),
         ...);
    }
    (std::make_integer_sequence<int, pairs>{});
}

/// The same as for_each_tap with equal weights of 1.
template <int radius, class Px, class Body> QUELL_KERNEL void for_each_neighbour(Px const& px, Body&& body) {
    float ones[radius + 1];
    for (float& one : ones) one = 1.f;
    for_each_tap<radius>(px, 1, ones, body);
}

} // namespace quell
