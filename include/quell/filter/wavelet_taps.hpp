#pragma once

#include <quell/filter/edge_taps.hpp>

#include <cstddef>
#include <iterator>
#include <type_traits>

/// The taps of an a-trous wavelet: how many, their weights, and how far apart they are from level to level.
namespace quell::inline QUELL_INSTRUCTION_SET {

/// 5x5 taps of a wavelet: a B3 spline (Dammertz 2010). 1, 2, 4, 8, ... pixels apart.
struct CubicSpline {
    static constexpr float weights[] = {0.375f, 0.25f, 0.0625f}; ///< along one axis, from the centre outwards
};
/// 3x3 taps of a wavelet: a third of the taps of CubicSpline, and half the reach. 1, 2, 4, 8, ... pixels apart.
struct LinearSpline {
    static constexpr float weights[] = {0.5f, 0.25f}; ///< along one axis, from the centre outwards
};
/// 3x3 taps of a wavelet: a linear spline in the first level, equal weights in the others. Of all weights over 3x3, equal ones leave the
/// least noise, so that fewer levels do, whose taps are further apart: 1, 2, 5, 12, ... pixels.
struct LinearThenBox {};

namespace detail {
/// 3x3 equal taps.
struct BoxSpline {
    static constexpr float weights[] = {1.f / 3.f, 1.f / 3.f};
};
/// A spline's weights, by |column| and |row|.
template <class Spline> struct SplineBits {
    static constexpr int radius = static_cast<int>(std::size(Spline::weights)) - 1;
    WeightBits at[std::size_t{radius + 1}][std::size_t{radius + 1}];
    constexpr SplineBits() : at{} {
        for (int i = 0; i <= radius; ++i)
            for (int j = 0; j <= radius; ++j) at[i][j] = WeightBits::of(Spline::weights[i] * Spline::weights[j]);
    }
};
/// Taps that are the same in all levels: constants of the kernel.
template <class Spline> struct SplineTaps {
    static constexpr int radius = SplineBits<Spline>::radius;
    static constexpr float centre = Spline::weights[0] * Spline::weights[0];
    /// The weight of a tap other than the centre, by column and row from there.
    static constexpr WeightBits at(int i, int j) {
        constexpr SplineBits<Spline> bits; // in here, since a device cannot read a table of the class
        return bits.at[i < 0 ? -i : i][j < 0 ? -j : j];
    }
};
/// 3x3 taps as a value, so that levels of different taps are one kernel.
struct NearestTaps {
    static constexpr int radius = 1;
    float centre;
    WeightBits beside, at_corner;
    /// The weight of a tap other than the centre, by column and row from there.
    [[nodiscard]] constexpr WeightBits at(int i, int j) const { return i != 0 && j != 0 ? at_corner : beside; }
};
template <class Spline>
inline constexpr NearestTaps nearest_taps{SplineTaps<Spline>::centre, SplineTaps<Spline>::at(1, 0), SplineTaps<Spline>::at(1, 1)};

template <class Spline> using TapsOf = std::conditional_t<std::is_same_v<Spline, LinearThenBox>, NearestTaps, SplineTaps<Spline>>;

/// Calls level(number, step, taps) for each level of a wavelet: its number from 0, and how many pixels its taps are apart.
template <class Spline> constexpr void for_each_level(int levels, int first_step, auto const& level) {
    constexpr bool box = std::is_same_v<Spline, LinearThenBox>;
    for (int i = 0, step = first_step; i < levels; ++i, step = box ? step * 5 / 2 : step * 2)
        if constexpr (box)
            level(i, step, i == 0 ? nearest_taps<LinearSpline> : nearest_taps<BoxSpline>);
        else
            level(i, step, SplineTaps<Spline>{});
}
} // namespace detail

} // namespace quell::inline QUELL_INSTRUCTION_SET
