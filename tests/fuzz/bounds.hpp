#pragma once

#include <quell/pipeline/composite.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

// The least and the greatest sample that a pipeline has been shown: what comes out of it must lie between them.
namespace quell::fuzz {

/// What docs/channels.md says of a sample: finite, at most 1e16, and not of negative luminance.
template <class V> bool is_sample(V const& v) {
    return fold([](bool sofar, float a) { return sofar && is_finite(a) && std::abs(a) <= 1e16f; }, true, v) && luminance(v) >= 0.f;
}
/// What docs/channels.md says of the divisor.
inline glm::vec3 divisor(glm::vec3 a) {
    for (int c = 0; c < 3; ++c)
        if (!is_finite(a[c]) || a[c] < 0.f) return glm::vec3(1.f);
    a = {std::min(a.x, 1.f), std::min(a.y, 1.f), std::min(a.z, 1.f)};
    if (luminance(a) < 0.02f) return glm::vec3(1.f);
    return {std::max(a.x, 0.02f), std::max(a.y, 0.02f), std::max(a.z, 0.02f)};
}

/// Of one pipeline's samples since its history started, after the division by the albedo.
/// @tparam P a Pipeline
template <class P> class Bounds {
    using Signal = typename P::Output;
    static constexpr int count = Signal::components;
    static constexpr bool demodulates = std::is_same_v<typename P::Form, Demodulate>;
    static constexpr bool dims = std::is_same_v<typename P::Suppression, SuppressFireflies>;
    float low[count], high[count];

    /// What component c of a pixel was divided by.
    template <class F> static float part(F const& frame, int c, int x, int y) {
        if constexpr (demodulates && count == 3)
            return divisor({frame[albedo].view().get(0, x, y), frame[albedo].view().get(1, x, y), frame[albedo].view().get(2, x, y)})[c];
        else
            return 1.f;
    }

public:
    Bounds() { start_over(); }
    void start_over() {
        std::fill_n(low, count, std::numeric_limits<float>::max());
        std::fill_n(high, count, std::numeric_limits<float>::lowest());
    }
    template <class F> void see(F const& frame) {
        auto const samples = frame[Signal{}].view();
        for (int y = 0; y < frame.size.height; ++y)
            for (int x = 0; x < frame.size.width; ++x) {
                if (!is_sample(make_value<count, float>([&](auto c) { return samples.get(c, x, y); }))) continue;
                for (int c = 0; c < count; ++c) {
                    float const a = samples.get(c, x, y) / part(frame, c, x, y);
                    low[c] = std::min(low[c], a), high[c] = std::max(high[c], a);
                    // A firefly is dimmed.
                    if (dims) low[c] = std::min(low[c], 0.f), high[c] = std::max(high[c], 0.f);
                }
            }
    }
    /// Calls fail(x, y, value, least, most) for each component outside the bounds. Where no sample was seen, only 0 is inside.
    /// @param rounding relative to the largest sample
    /// @param smallest number above 0 that the history can hold
    /// @param largest  one
    template <class F> void check(F const& frame, auto const& out, float rounding, float smallest, float largest, auto&& fail) const {
        for (int c = 0; c < count; ++c) {
            bool const none = high[c] < low[c];
            float const least = none ? 0.f : std::clamp(low[c], -largest, largest),
                        most = none ? 0.f : std::clamp(high[c], -largest, largest);
            float const slack = std::max(std::abs(least), std::abs(most)) * rounding;
            for (int y = 0; y < frame.size.height; ++y)
                for (int x = 0; x < frame.size.width; ++x) {
                    float const d = part(frame, c, x, y), a = out.get(c, x, y) / d, step = smallest / d;
                    if (!(a >= least - slack - step && a <= most + slack + step)) fail(x, y, a, least, most);
                }
        }
    }
};

} // namespace quell::fuzz
