#pragma once

#include <quell/execute/executor.hpp>
#include <quell/image/image_storage.hpp>
#include <quell/link/checkerboard.hpp>

#include <limits>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

inline constexpr int none_held_out = -1; ///< of HoldOut::half

/// Copies samples. Those that are held out become missing ones.
template <class From, class To> struct HoldOut {
    static constexpr auto name = "hold samples out";
    From from;
    To output;
    int half; ///< of a checkerboard that is held out: pixels whose x + y is even (0) or odd (1); or none

    template <class Real> QUELL_KERNEL void operator()(AtOnce<Real>, Coordinate<Real> x, Coordinate<Real> y, int count) const {
        auto const off = checkerboard_half(Real(to_real(x)) + lanes<Real>(), Real(to_real(y))) - static_cast<float>(half);
        auto const is_held = off * off < Real(.25f);
        auto const held = [&](Real value) QUELL_INLINED { return select(is_held, Real(std::numeric_limits<float>::quiet_NaN()), value); };
        store_pixels<Real>(output, x, y, map(held, load_pixels<Real>(from, x, y)), count);
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
