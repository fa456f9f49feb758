#pragma once

#include <quell/filter/edge_taps.hpp>
#include <quell/frame/cursor/taps.hpp>
#include <quell/shader/recorded_cursor.hpp>
#include <quell/shader/recorded_loop.hpp>

/// @file
/// Loops over taps that skip rows outside the image by a branch: recorded, such rows have weight 0, as columns have.

namespace quell::inline QUELL_INSTRUCTION_SET {

/// @cond
namespace detail {
template <class Px>
concept RecordedCursor = std::same_as<typename Px::Real, Recorded>;
/// The weight of a tap: 0 outside the image. Rounded as for_each_tap() rounds it.
template <int radius> Recorded tap_weight(auto const& tap, float const (&profile)[std::size_t{radius + 1}], int i, int j) {
    return masked(tap.inside(), Recorded(profile[i < 0 ? -i : i])) * profile[j < 0 ? -j : j];
}
} // namespace detail

template <int radius, detail::RecordedCursor Px, class Body>
void for_each_tap(Px const& px, int step, float const (&profile)[std::size_t{radius + 1}], Body&& body) {
    for (int j = -radius; j <= radius; ++j)
        for (int i = -radius; i <= radius; ++i) {
            auto const near_by = px.at(i * step, j * step);
            body(near_by, detail::tap_weight<radius>(near_by, profile, i, j), i * step, j * step);
        }
}

template <int radius, detail::RecordedCursor Px, class Body>
void for_each_tap_pair(Px const& px, int step, float const (&profile)[std::size_t{radius + 1}], Body&& body) {
    constexpr int side = 2 * radius + 1;
    for (int k = 0; k < side * side / 2; ++k) {
        int const i = k % side - radius, j = k / side - radius;
        auto const one = px.at(i * step, j * step), other = px.at(-i * step, -j * step);
        body(one, detail::tap_weight<radius>(one, profile, i, j), other, detail::tap_weight<radius>(other, profile, i, j), i * step,
             j * step);
    }
}

template <bool skips_missing, int radius, detail::RecordedCursor Px, class Around, class Body>
void for_each_edge_tap(Px const& px, int step, Around const& around, Body&& body) {
    // Such a distance gives rows outside the smallest weight too.
    auto const tap = [&](int i, int j, auto const& toward) {
        auto const one = px.at(i * step, j * step);
        auto const start = select(one.inside(), Recorded(detail::edge_offset(around)), Recorded(too_far));
        body(EdgeTap<Px>{one, toward.distance(one, detail::start_at<skips_missing>(one, start)), i, j, 0.f});
    };
    for (int j = 0; j <= radius; ++j)
        for (int i = j == 0 ? 1 : -radius; i <= radius; ++i) {
            auto const& toward = detail::edge_toward(around, i * step, j * step);
            tap(i, j, toward), tap(-i, -j, toward);
        }
}
/// @endcond

} // namespace quell::inline QUELL_INSTRUCTION_SET
