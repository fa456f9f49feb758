#pragma once

#include <quell/frame/pixel.hpp>

namespace quell {

/// Divides the signal by the albedo before anything else sees it and multiplies the result by the same divisor at the end, so that texture
/// is not filtered. The divisor is never small: a black surface and a miss (whose albedo hosts leave at anything) pass through unchanged.
struct Demodulate {
    using reads = Channels<Albedo>;
    float least = 0.02f; ///< a component's divisor is at least this; a surface whose luminance is less divides by 1

    QUELL_KERNEL auto divisor(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const a = px[albedo];
        auto const colour = map(
            [&](auto c) __attribute__((always_inline)) { return select(is_finite(c), clamp(c, Real(least), Real(1e4f)), Real(1.f)); }, a);
        auto const black = either(invert(all_finite(a)), luminance(a) < Real(least));
        return select(black, splat<decltype(a + a)>(Real(1.f)), colour);
    }
};

/// Leaves the signal as it is.
struct NoModulation {};

} // namespace quell
