#pragma once

#include <quell/blend/variance_over_time.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Also keeps mean and variance over time of the samples' luminance, updated with the inner policy's alpha. For VarianceGuidedAtrous.
/// @tparam Inner a BlendPolicy
template <class Inner> struct WithMoments {
    static_assert(BlendPolicy<Inner>, "WithMoments{inner}: `inner` must have blend(px, past), see quell/blend/blend_policy.hpp");
    using parts = Parts<Inner>;
    using keeps = Channels<LuminanceMean, LuminanceVariance>;
    static constexpr int farthest_tap = 0;
    Inner inner{}; ///< blends, and says alpha

    /// The inner result, with luminance_mean and luminance_variance.
    QUELL_KERNEL auto blend(auto px, auto past) const {
        auto const result = result_of([&]() QUELL_INLINED { return inner.blend(px, past); });
        auto const alpha = result.alpha;
        auto const before = past[luminance_mean];
        auto const off = luminance(px.signal()) - before;
        auto const mean = before + off * alpha;
        return result.with(luminance_mean, mean)
            .with(luminance_variance, detail::variance_over_time(px, past[luminance_variance], off, alpha));
    }
};
template <class Inner> WithMoments(Inner) -> WithMoments<Inner>;

} // namespace quell::inline QUELL_INSTRUCTION_SET
