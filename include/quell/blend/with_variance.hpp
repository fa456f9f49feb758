#pragma once

#include <quell/blend/variance_over_time.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Like WithMoments, but takes the mean from the history of the signal itself, which saves one number per pixel. Only right where that is
/// the mean of the samples seen: not with a clamp, and not with a filter that feeds back.
/// @tparam Inner a BlendPolicy
template <class Inner> struct WithVariance {
    static_assert(BlendPolicy<Inner>, "WithVariance{inner}: `inner` must have blend(px, past), see quell/blend/blend_policy.hpp");
    using parts = Parts<Inner>;
    using keeps = Channels<LuminanceVariance>;
    static constexpr int farthest_tap = 0;
    Inner inner{}; ///< blends, and says alpha

    /// The inner policy's: what is left of it is hidden sooner, by the filter as wide as the remaining noise that follows.
    [[nodiscard]] constexpr BlendMemory memory() const { return memory_of(inner).hidden_after(2.f); }

    /// The inner result, with luminance_variance.
    QUELL_KERNEL auto blend(auto px, auto past) const {
        auto const result = result_of([&]() QUELL_INLINED { return inner.blend(px, past); });
        auto const off = luminance(px.signal()) - luminance(past.signal);
        return result.with(luminance_variance, detail::variance_over_time(px, past[luminance_variance], off, result.alpha));
    }
};
template <class Inner> WithVariance(Inner) -> WithVariance<Inner>;

} // namespace quell::inline QUELL_INSTRUCTION_SET
