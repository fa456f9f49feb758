#pragma once

#include <quell/frame/cursor/pixel.hpp>
#include <quell/frame/hull.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Leaves the output as it is.
struct NoSharpening {};

/// Takes the mean of the four neighbours away, and limits the result to what the five hold, so that edges get no bright or dark seams.
struct Sharpen {
    static constexpr auto name = "sharpen"; ///< of the pass
    static constexpr int farthest_tap = 1;  ///< see FilterKernel
    float amount = 0.25f;                   ///< 0: none; 1: strong

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
    /// As a filter. Outside the image lies what the border has.
    QUELL_KERNEL auto filter(auto px) const {
        using V = typename decltype(px)::Signal;
        V const centre = px.signal();
        auto const beside = [&](int dx, int dy) QUELL_INLINED {
            auto const tap = px.at(dx, dy);
            return select(tap.inside(), V(tap.signal()), centre);
        };
        V const four[] = {beside(-1, 0), beside(1, 0), beside(0, -1), beside(0, 1)};
        return (*this)(centre, four);
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
