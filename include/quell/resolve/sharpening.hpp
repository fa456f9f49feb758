#pragma once

#include <quell/frame/hull.hpp>

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

} // namespace quell::inline QUELL_INSTRUCTION_SET
