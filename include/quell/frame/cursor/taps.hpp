#pragma once

#include <quell/frame/cursor/pixel.hpp>

namespace quell {

namespace detail {
/// Calls f(0) to f(n - 1): unrolled while that is short, since then addresses become constants; else as a loop, which compiles faster.
template <int n, class F> QUELL_KERNEL void repeat(F&& f) {
    if constexpr (n <= 5) [&]<int... i>(std::integer_sequence<int, i...>) QUELL_INLINED {
            (f(std::integral_constant<int, i>{}), ...);
        }
    (std::make_integer_sequence<int, n>{});
    else for (int i = 0; i < n; ++i) f(i);
}
} // namespace detail

/// Calls `body(near, weight, dx, dy)` for every pixel of a (2 radius + 1)^2 neighbourhood whose taps stand `step` pixels apart; `near` is
/// the cursor there. `weight` is profile[|column|] * profile[|row|], and 0 outside the image: whatever a kernel sums with it is
/// renormalised at borders. Rows outside are skipped whole.
template <int radius, class Px, class Body>
QUELL_KERNEL void for_each_tap(Px const& px, int step, float const (&profile)[radius + 1], Body&& body) {
    using Real = typename Px::Real;
    constexpr int side = 2 * radius + 1;
    // What depends on the column is worked out once, not once a row.
    Real across[side];
    int column[side];
    detail::repeat<side>([&](auto i) QUELL_INLINED {
        auto const beside = px.at((i - radius) * step, 0);
        across[i] = masked(beside.inside(), Real(profile[i < radius ? radius - i : i - radius]));
        column[i] = beside.x;
    });
    for (int j = -radius; j <= radius; ++j) {
        int const row = px.y + j * step;
        if (row < 0 || row >= px.size().height) continue;
        float const down = profile[j < 0 ? -j : j];
        detail::repeat<side>([&](auto i) QUELL_INLINED {
            body(Px{px.scope, column[i], row}, across[i] * down, (i - radius) * step, j * step);
        });
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
    detail::repeat<side>([&](auto i) QUELL_INLINED {
        auto const beside = px.at((i - radius) * step, 0), below = px.at(0, (i - radius) * step);
        float const weight = profile[i < radius ? radius - i : i - radius];
        across[i] = masked(beside.inside(), Real(weight));
        column[i] = beside.x;
        down[i] = below.row_inside ? weight : 0.f;
        row[i] = below.y;
    });
    [&]<int... k>(std::integer_sequence<int, k...>) QUELL_INLINED {
        constexpr int last = side * side - 1;
        (body(Px{px.scope, column[k % side], row[k / side]}, across[k % side] * down[k / side],
              Px{px.scope, column[(last - k) % side], row[(last - k) / side]}, across[(last - k) % side] * down[(last - k) / side],
              (k % side - radius) * step, (k / side - radius) * step),
         ...);
    }
    (std::make_integer_sequence<int, pairs>{});
}

/// Calls `body(near, inside)` for the five pixels in a row or a column around this one that stand `step` pixels apart; `inside` is false
/// where there is none. For sums over windows, which rows and columns put together.
template <class Px, class Body> QUELL_KERNEL void for_each_of_five(Px const& px, int step, bool vertical, Body&& body) {
    for (int i = -2; i <= 2; ++i) {
        auto const neighbour = vertical ? px.at(0, i * step) : px.at(i * step, 0);
        body(neighbour, neighbour.inside());
    }
}

/// A distance so far, and a weight's bits so low, that edge_weight is the least there is.
inline constexpr float too_far = 1e9f, too_little = -1e10f;

/// For filters whose weights are edge weights: opposite taps without the centre, `body(near, start, row, opposite, its start, its row, dx,
/// dy, i, j)`, where tap (i, j) stands `step` times as far away, at (dx, dy). A tap's distances are to be added to `start`, which is `base`
/// or, in columns outside the image, too_far; `row` is to be added to its weight's bits and is 0 or, in rows outside, too_little: so
/// borders cost nothing. A loop: unrolled, it took longer to compile and no less to run.
template <int radius, class Px, class Body> QUELL_KERNEL void for_each_opposite_taps(Px const& px, int step, float base, Body&& body) {
    using Real = typename Px::Real;
    constexpr int side = 2 * radius + 1;
    Real start[side];
    int column[side];
    for (int i = 0; i < side; ++i) {
        auto const beside = px.at((i - radius) * step, 0);
        start[i] = select(beside.inside(), Real(base), Real(too_far));
        column[i] = beside.x;
    }
    for (int j = 0; j <= radius; ++j) {
        auto const below = px.at(0, j * step), above = px.at(0, -j * step);
        float const row = below.row_inside ? 0.f : too_little, opposite_row = above.row_inside ? 0.f : too_little;
        for (int i = j == 0 ? 1 : -radius; i <= radius; ++i)
            body(Px{px.scope, column[radius + i], below.y}, start[radius + i], row, Px{px.scope, column[radius - i], above.y},
                 start[radius - i], opposite_row, i * step, j * step, i, j);
    }
}

/// The same as for_each_tap with equal weights of 1.
template <int radius, class Px, class Body> QUELL_KERNEL void for_each_neighbour(Px const& px, int step, Body&& body) {
    float ones[radius + 1];
    for (float& one : ones) one = 1.f;
    for_each_tap<radius>(px, step, ones, body);
}
template <int radius, class Px, class Body> QUELL_KERNEL void for_each_neighbour(Px const& px, Body&& body) {
    for_each_neighbour<radius>(px, 1, body);
}

} // namespace quell
