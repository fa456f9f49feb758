#pragma once

#include <quell/blend/blend_policy.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Emits the deviation in pixels for a CleanUp filter: min((alpha - usual_alpha)^2 + clamped, widest) (TRMV eqs. 7 and 8). It is large
/// where little history was used, or where a clamp moved it; so a clamp goes outside. Does not change the inner policy's result.
///
///     Temporal{SurfaceMotion{}, Clamped{WithCleanUp{Exponential{.alpha = 0.1f}}}}
///
/// @tparam Inner a BlendPolicy
template <class Inner> struct WithCleanUp {
    static_assert(BlendPolicy<Inner>, "WithCleanUp{inner}: `inner` must have blend(px, past), see quell/blend/blend_policy.hpp");
    using parts = Parts<Inner>;
    using emits = Channels<CleanUpDeviation>;
    static constexpr int farthest_tap = 0;
    Inner inner{};            ///< blends, and says alpha
    float usual_alpha = 0.1f; ///< up to this alpha no clean-up is needed
    float widest = 5.f;       ///< pixels

    /// The inner result, with clean_up_deviation.
    QUELL_KERNEL auto blend(auto px, auto past) const {
        using Real = typename decltype(px)::Real;
        auto const result = result_of([&]() QUELL_INLINED { return inner.blend(px, past); });
        auto const excess = max(result.alpha - usual_alpha, Real(0.f));
        return result.with(clean_up_deviation, min(fma(excess, excess, past.clamped), Real(widest)));
    }
};
template <class Inner> WithCleanUp(Inner) -> WithCleanUp<Inner>;

} // namespace quell::inline QUELL_INSTRUCTION_SET
