#pragma once

#include <quell/resolve/spline_interpolation.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Leaves the output as it is.
struct NoSharpening {};

/// Takes the mean of the four neighbours away, and limits the result to what the five hold, so that edges get no bright or dark seams.
struct Sharpen {
    float amount = 0.25f; ///< 0: none; 1: strong

    /// @param centre a pixel
    /// @param beside the four beside it
    template <class V> QUELL_KERNEL V operator()(V const& centre, V const (&beside)[4]) const {
        detail::Hull<V> hull(centre);
        auto sum = zero<V>();
        for (auto const& each : beside) {
            hull.add(each);
            sum = add_scaled(sum, each, real_of<V>(0.25f));
        }
        return hull.limited(map([&](auto c, auto mean) QUELL_INLINED { return fma(c - mean, real_of<V>(amount), c); }, centre, sum));
    }
};

namespace detail {
/// The pass of a sharpening.
template <class Sharpening, class From, class To> struct SharpenJob {
    static constexpr auto name = "sharpen";
    Sharpening sharpening;
    From from;
    To to;

    template <class Real> QUELL_KERNEL void operator()(AtOnce<Real>, int x, int y, int count) const {
        using V = Value<From::components, Real>;
        TapsAround<Real> const taps(from.size, Real(static_cast<float>(x)) + lanes<Real>(), Real(static_cast<float>(y)));
        V const beside[] = {taps.at(from, -1, 0), taps.at(from, 1, 0), taps.at(from, 0, -1), taps.at(from, 0, 1)};
        store_pixels<Real>(to, x, y, sharpening(V(taps.at(from, 0, 0)), beside), count);
    }
};
template <class Sharpening, class From, class To> SharpenJob(Sharpening, From, To) -> SharpenJob<Sharpening, From, To>;
} // namespace detail

} // namespace quell::inline QUELL_INSTRUCTION_SET
