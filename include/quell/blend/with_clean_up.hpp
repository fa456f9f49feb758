#pragma once

#include <quell/blend/blend_policy.hpp>

namespace quell {

/// Says, beside what the inner policy does, how wide a CleanUp filter should be here: wide where less history was used than usual, or where
/// a clamp moved it (TRMV eqs. 7 and 8): min((alpha - usual_alpha)^2 + clamped, widest).
///     Temporal{SurfaceMotion{}, Clamped{WithCleanUp{Exponential{.alpha = 0.1f}}}}
template <class Inner> struct WithCleanUp {
    static_assert(BlendPolicy<Inner>, "WithCleanUp{inner}: `inner` must have blend(px, past), see quell/blend/blend_policy.hpp");
    using parts = Parts<Inner>;
    using emits = Channels<CleanUpDeviation>;
    Inner inner{};
    float usual_alpha = 0.1f;
    float widest = 5.f; ///< pixels

    QUELL_KERNEL auto blend(auto px, auto past) const {
        using Real = typename decltype(px)::Real;
        auto const result = detail::result_of([&]() QUELL_INLINED { return inner.blend(px, past); });
        auto const excess = max(result.alpha - usual_alpha, Real(0.f));
        return result.with(clean_up_deviation, min(fma(excess, excess, past.clamped), Real(widest)));
    }
};
template <class Inner> WithCleanUp(Inner) -> WithCleanUp<Inner>;

} // namespace quell
