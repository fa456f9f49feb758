#pragma once

#include <quell/core/recording.hpp>
#include <quell/frame/cursor/pixel.hpp>

#include <cstddef>

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {
/// Calls f(0) to f(n - 1). Up to 5 calls are unrolled, so addresses become constants; a loop of more compiles faster.
template <int n, class F> QUELL_KERNEL void repeat(F&& f) {
    if constexpr (n <= 5) [&]<int... i>(std::integer_sequence<int, i...>) QUELL_INLINED {
            (f(std::integral_constant<int, i>{}), ...);
        }
    (std::make_integer_sequence<int, n>{});
    else for (int i = 0; i < n; ++i) f(i);
}
} // namespace detail

/// Calls `body(near, weight, dx, dy)` for each tap of a separable kernel of (2 radius + 1)^2 taps, `step` pixels apart. `near` is the
/// cursor at the tap, (dx, dy) its offset in pixels. `weight` is profile[|column|] * profile[|row|] (distances in taps), and 0 in columns
/// outside the image. Rows outside are skipped. Divide sums by the sum of the weights.
/// @tparam radius in taps
template <int radius, class Px, class Body>
    requires(!records<typename Px::Real>)
QUELL_KERNEL void for_each_tap(Px const& px, int step, float const (&profile)[std::size_t{radius + 1}], Body&& body) {
    using Real = typename Px::Real;
    constexpr int side = 2 * radius + 1;
    if constexpr (Px::pack_width < width_of<Real>) { // rows differ in what is inside
        for (int j = -radius; j <= radius; ++j)
            for (int i = -radius; i <= radius; ++i) {
                auto const near_by = px.at(i * step, j * step);
                if (near_by.any_row_inside())
                    body(near_by, masked(near_by.inside(), Real(profile[i < 0 ? -i : i] * profile[j < 0 ? -j : j])), i * step, j * step);
            }
        return;
    }
    // What depends on the column only is computed once.
    Real across[std::size_t{side}];
    int column[std::size_t{side}];
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

/// The same taps in opposite pairs, without the centre: `body(near, weight, opposite, weight of opposite, dx, dy)`. What depends on the
/// distance only is computed once for two taps. Rows outside have weight 0. It is unrolled: use small radii.
template <int radius, class Px, class Body>
    requires(!records<typename Px::Real>)
QUELL_KERNEL void for_each_tap_pair(Px const& px, int step, float const (&profile)[std::size_t{radius + 1}], Body&& body) {
    static_assert(Px::pack_width == width_of<typename Px::Real>, "a pass of `two_rows` takes taps by for_each_tap");
    using Real = typename Px::Real;
    constexpr int side = 2 * radius + 1, pairs = side * side / 2;
    Real across[std::size_t{side}];
    int column[std::size_t{side}], row[std::size_t{side}];
    float down[std::size_t{side}];
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

/// Calls `body(near, inside)` for five pixels of a row or column, `step` pixels apart, centred here. `inside` is false outside the image.
/// For separable sums over windows.
template <class Px, class Body> QUELL_KERNEL void for_each_of_five(Px const& px, int step, bool vertical, Body&& body) {
    for (int i = -2; i <= 2; ++i) {
        auto const neighbour = vertical ? px.at(0, i * step) : px.at(i * step, 0);
        body(neighbour, neighbour.inside());
    }
}

/// As for_each_tap, with weights 1.
template <int radius, class Px, class Body> QUELL_KERNEL void for_each_neighbour(Px const& px, int step, Body&& body) {
    float ones[std::size_t{radius + 1}];
    for (float& one : ones) one = 1.f;
    for_each_tap<radius>(px, step, ones, body);
}
/// As for_each_tap, with weights 1 and step 1.
template <int radius, class Px, class Body> QUELL_KERNEL void for_each_neighbour(Px const& px, Body&& body) {
    for_each_neighbour<radius>(px, 1, body);
}

} // namespace quell::inline QUELL_INSTRUCTION_SET
