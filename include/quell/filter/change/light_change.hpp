#pragma once

#include <quell/blend/blend_policy.hpp>
#include <quell/filter/filter_kernel.hpp>
#include <quell/motion/surface_motion.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Difference of luminance between new samples and history, over a window of n pixels. x: sum / sqrt(n). y: root of the sum of squares,
/// over sqrt(n). x / y is Student's statistic, and both fit in half precision.
struct LightChange : InternalChannel<2> {
    static constexpr auto name = "light_change";
};
inline constexpr LightChange light_change;

namespace detail {
/// A pixel's history without interpolation, and `distance`: luminance now minus luminance then. `known`: there is a sample and a history.
template <class P, class Real, class Mask> struct BesidePast {
    P past;
    Real distance;
    Mask known;
};
template <class P, class Real, class Mask> BesidePast(P, Real, Mask) -> BesidePast<P, Real, Mask>;
template <class Px> QUELL_KERNEL auto beside_past(Px const& px, auto const& source) {
    using Real = typename Px::Real;
    auto const past = Nearest{}.fetch(px, source.previous(px));
    auto const distance = luminance(px.signal()) - luminance(past.signal);
    return BesidePast{past, distance, both(past.validity > Real(0.f), invert(px.missing()), is_finite(distance))};
}

/// The pixel's own difference; 0 without a sample or a history.
template <class Source> struct OwnLightChange {
    static constexpr auto name = "light change";
    using parts = Parts<Source>;
    using emits = Channels<LightChange>;
    static constexpr bool reads_past_signal = true;
    static constexpr int farthest_tap = 0;
    Source source;

    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        Real distance(0.f);
        if (px.has_past()) {
            auto const found = beside_past(px, source);
            distance = select(found.known, found.distance, distance);
        }
        return emitted<Real>(light_change, vec2<Real>{distance, abs(distance)});
    }
};

/// Combines five pixels of a row or a column.
struct LightChangeLine {
    static constexpr auto name = "light change";
    using reads = Channels<LightChange>;
    using emits = Channels<LightChange>;
    int step;
    bool vertical;

    constexpr int farthest_tap() const { return 2 * step; }

    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        Real sum(0.f), squares(0.f);
        for_each_of_five(px, step, vertical, [&](auto const& neighbour, auto inside) QUELL_INLINED {
            auto const change = neighbour[light_change];
            sum = sum + masked(inside, change.x);
            squares = squares + masked(inside, change.y * change.y);
        });
        return emitted<Real>(light_change, vec2<Real>{sum * 0.4472136f, sqrt(squares * 0.2f)});
    }
};
} // namespace detail

/// Measures where the light has changed by itself, so that the history is wrong though motion vectors are right. In one pixel, noise hides
/// the change; over a window the noise cancels. Goes before a Temporal{..., ForgetChanged{...}}.
///
///     Spatial{ChangeDetector<>{}}, Temporal{SurfaceMotion{}, ForgetChanged{RunningMean{}}}
///
/// @tparam Source the MotionSource by which the history is found
template <class Source = SurfaceMotion<SameDepth>> struct ChangeDetector {
    /// @cond
    using Own = detail::OwnLightChange<Source>;
    using Line = detail::LightChangeLine;
    using parts = Parts<Own>;
    static constexpr bool leaves_signal = true;
    /// @endcond
    Source source{}; ///< finds the history
    int levels = 2;  ///< window: 1 is 5x5 pixels, 2 is 25x25, which tolerates more noise and is less sharp

    /// Own differences, then rows and columns for each level.
    constexpr void for_each_pass(auto&& pass) const {
        pass(Own{source});
        for (int i = 0, step = 1; i < levels; ++i, step *= 5) {
            pass(Line{step, false});
            pass(Line{step, true});
        }
    }
};

/// Forgets history by the evidence of a ChangeDetector. The statistic is (sum of differences)^2 / (sum of their squares). Without change it
/// is 1 on average, however heavy-tailed the noise: a single firefly makes it 1. With change it grows with the number of pixels. Decorates
/// a policy that uses the validity of the history, such as RunningMean.
/// @tparam Inner a BlendPolicy
template <class Inner> struct ForgetChanged {
    static_assert(BlendPolicy<Inner>, "ForgetChanged{inner}: `inner` must have blend(px, past), see quell/blend/blend_policy.hpp");
    using parts = Parts<Inner>;
    using reads = Channels<LightChange>;
    static constexpr int farthest_tap = 0;
    Inner inner{};                ///< blends with the reduced validity
    float noise_threshold = 16.f; ///< values of the statistic up to this are noise
    float sharpness = 400.f;      ///< validity is divided by 1 + sharpness * (statistic - noise_threshold); longer histories need more

    /// The inner policy's result with the reduced validity.
    QUELL_KERNEL auto blend(auto px, auto past) const {
        using Real = typename decltype(px)::Real;
        auto const change = px[light_change];
        auto const ratio = change.x / max(change.y, Real(1e-37f));
        auto const excess = max(ratio * ratio - noise_threshold, Real(0.f));
        past.validity = past.validity / fma(excess, Real(sharpness), Real(1.f));
        return inner.blend(px, past);
    }
};
template <class Inner> ForgetChanged(Inner) -> ForgetChanged<Inner>;

} // namespace quell::inline QUELL_INSTRUCTION_SET
