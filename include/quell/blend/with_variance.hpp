#pragma once

#include <quell/blend/variance_over_time.hpp>

namespace quell {

/// Keeps, beside what the inner policy does, the variance over time of each pixel's luminance, with the same alpha, as WithMoments does;
/// but takes the mean from the signal itself, so that there is one number less to keep. For policies whose value is the mean of what they
/// have seen, which a clamp or a filter that feeds back makes untrue.
template <class Inner> struct WithVariance {
    static_assert(BlendPolicy<Inner>, "WithVariance{inner}: `inner` must have blend(px, past), see quell/blend/blend_policy.hpp");
    using parts = Parts<Inner>;
    using keeps = Channels<LuminanceVariance>;
    Inner inner{};

    QUELL_KERNEL auto blend(auto px, auto past) const {
        auto const result = detail::result_of([&]() QUELL_INLINED { return inner.blend(px, past); });
        auto const off = luminance(px.signal()) - luminance(past.signal);
        return result.with(luminance_variance, detail::variance_over_time(px, past[luminance_variance], off, result.alpha));
    }
};
template <class Inner> WithVariance(Inner) -> WithVariance<Inner>;

} // namespace quell
