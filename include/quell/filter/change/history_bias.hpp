#pragma once

#include <quell/blend/variance_over_time.hpp>
#include <quell/filter/change/light_change.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Squared bias of the history over the variance of one sample; 0 without evidence.
struct HistoryBias : InternalChannel<1> {
    static constexpr auto name = "history_bias";
};
inline constexpr HistoryBias history_bias;

// What BiasEstimate measures, as means over a window. Four channels of one component, so that later passes can reuse their memory.

/// Luminance of the sample minus luminance of the history.
struct HistoryDistance : InternalChannel<1> {
    static constexpr auto name = "history_distance";
};
/// Root mean square of HistoryDistance.
struct HistoryDeviation : InternalChannel<1> {
    static constexpr auto name = "history_deviation";
};
/// Root mean square that noise alone would give, by the history's own variance.
struct ExpectedDeviation : InternalChannel<1> {
    static constexpr auto name = "expected_deviation";
};
/// Part of the window that has both a sample and a history.
struct HistoryShare : InternalChannel<1> {
    static constexpr auto name = "history_share";
};
inline constexpr HistoryDistance history_distance;
inline constexpr HistoryDeviation history_deviation;
inline constexpr ExpectedDeviation expected_deviation;
inline constexpr HistoryShare history_share;

namespace detail {
using WindowChannels = Channels<HistoryDistance, HistoryDeviation, ExpectedDeviation, HistoryShare>;

template <class Real> struct WindowOfHistory {
    Real distance, deviation, expected, share;

    QUELL_KERNEL auto emitted() const {
        return quell::emitted<Real>(history_distance, distance)
            .with(history_deviation, deviation)
            .with(expected_deviation, expected)
            .with(history_share, share);
    }
};
template <class Px> QUELL_KERNEL auto window_at(Px const& px) {
    return WindowOfHistory<typename Px::Real>{px[history_distance], px[history_deviation], px[expected_deviation], px[history_share]};
}

/// The measurements of one pixel; 0 without a sample or a history.
template <class Source> struct OwnHistoryDistance {
    static constexpr auto name = "history distance";
    using parts = Parts<Source>;
    using reads_kept = Channels<HistoryLength, LuminanceVariance>;
    using emits = WindowChannels;
    static constexpr bool reads_past_signal = true;
    static constexpr int farthest_tap = 0;
    Source source;

    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        Real const none(0.f);
        if (!px.has_past()) return WindowOfHistory<Real>{none, none, none, none}.emitted();
        auto const [past, distance, known] = beside_past(px, source);
        auto const n = max(past[history_length], Real(1e-3f)), now = px.samples();
        auto const of_sample = masked(n > Real(1.f), unbiased_variance(past[luminance_variance], n));
        // Differences under 1/1000 of the light may be rounding or interpolation.
        auto const light_then = luminance(past.signal);
        auto const expected = fma(light_then * light_then, Real(1e-6f), of_sample * (1.f / now + 1.f / n));
        auto const usable = both(known, is_finite(expected));
        return WindowOfHistory<Real>{masked(usable, distance), masked(usable, abs(distance)), masked(usable, sqrt(expected)),
                                     masked(usable, Real(1.f))}
            .emitted();
    }
};

/// Mean of five pixels of a row or a column; pixels outside the image count as 0.
struct HistoryDistanceLine {
    static constexpr auto name = "history distance";
    using reads = WindowChannels;
    using emits = WindowChannels;
    int step;
    bool vertical;

    constexpr int farthest_tap() const { return 2 * step; }

    QUELL_KERNEL auto emit_channels(auto px) const { return mean(px).emitted(); }
    QUELL_KERNEL auto mean(auto px) const {
        using Real = typename decltype(px)::Real;
        Real distance(0.f), square(0.f), expected(0.f), share(0.f);
        for_each_of_five(px, step, vertical, [&](auto const& neighbour, auto inside) QUELL_INLINED {
            auto const there = window_at(neighbour);
            distance = distance + masked(inside, there.distance);
            square = fma(there.deviation, masked(inside, there.deviation), square);
            expected = fma(there.expected, masked(inside, there.expected), expected);
            share = share + masked(inside, there.share);
        });
        return WindowOfHistory<Real>{distance * 0.2f, sqrt(square * 0.2f), sqrt(expected * 0.2f), share * 0.2f};
    }
};

inline constexpr float wide_window = 625.f; ///< in pixels: 25x25

/// Squared bias over variance, by one window: the squared mean difference beyond what noise explains, over the variance.
/// @param pixels    size of the window
/// @param noise_threshold variances of the window's mean that count as noise
template <class Real> QUELL_KERNEL Real bias_in(WindowOfHistory<Real> const& window, float pixels, float noise_threshold) {
    auto const share = 1.f / max(window.share, Real(1e-6f));
    auto const mean = window.distance * share;
    // With skewed noise, a window may lack the rare bright samples and look as if the light had changed. The history has seen them, so the
    // larger variance counts.
    auto const seen = fma(window.deviation, window.deviation * share, -mean * mean);
    auto const expected = window.expected * window.expected * share;
    auto const noise = max(max(seen, expected), Real(1e-37f));
    auto const count = max(window.share * pixels - 1.f, Real(0.5f));
    auto const excess = max(fma(mean, mean, -(noise * noise_threshold) / count), Real(0.f));
    return min(excess / noise, Real(1e6f));
}

/// Evaluates the 5x5 window, and does the rows of the 25x25 window.
struct NarrowBias {
    static constexpr auto name = "history bias";
    using reads = WindowChannels;
    using emits = decltype(WindowChannels{} | Channels<HistoryBias>{});
    static constexpr int farthest_tap = 10;
    float noise_threshold;

    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        return HistoryDistanceLine{5, false}.mean(px).emitted().with(history_bias, bias_in<Real>(window_at(px), 25.f, noise_threshold));
    }
};
/// Does the columns of the 25x25 window, and evaluates it.
struct WideBias {
    static constexpr auto name = "history bias";
    using reads = decltype(WindowChannels{} | Channels<HistoryBias>{});
    using emits = Channels<HistoryBias, HistoryDeviation>;
    static constexpr int farthest_tap = 10;
    float noise_threshold;

    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const wide = HistoryDistanceLine{5, true}.mean(px);
        return emitted<Real>(history_bias, max(px[history_bias], bias_in<Real>(wide, wide_window, noise_threshold)))
            .with(history_deviation, wide.deviation);
    }
};
} // namespace detail

/// Measures the bias of the history where light moves or changes and no motion vector says so. In one pixel, noise hides the bias; over a
/// window the noise cancels. There are two windows: 5x5 pixels for clear changes, sharply, and 25x25 for faint ones. Goes before a
/// Temporal{..., WithVariance{ForgetBiased{RunningMean{}}}}.
/// @tparam Source the MotionSource by which the history is found
template <class Source = SurfaceMotion<SameDepth>> struct BiasEstimate {
    /// @cond
    using Own = detail::OwnHistoryDistance<Source>;
    using parts = Parts<Own, detail::NarrowBias, detail::WideBias>;
    static constexpr bool leaves_signal = true;
    /// @endcond
    Source source{};              ///< finds the history
    float narrow_by_chance = 9.f; ///< variances of a window's mean that count as noise, for 5x5 pixels
    float wide_by_chance = 1.f;   ///< the same for 25x25

    /// Own differences, and the two windows.
    constexpr void for_each_pass(auto&& pass) const {
        pass(Own{source});
        pass(detail::HistoryDistanceLine{1, false});
        pass(detail::HistoryDistanceLine{1, true});
        pass(detail::NarrowBias{narrow_by_chance});
        pass(detail::WideBias{wide_by_chance});
    }
};

/// Shortens the history by its bias, as measured by a BiasEstimate. A mean of n samples has the squared error variance / n + bias^2. The
/// spatial filter then divides the variance by `gain` and leaves the bias. The history counts as the n' samples whose variance alone gives
/// that error:
///
///     n' = n / (1 + gain (n / now + 1) bias^2 / variance)            now: samples of the new frame
///
/// Fireflies in the history are forgotten at once: pixels where only the history is bright, and whose squared difference is more than
/// `firefly_share` of the sum over the 25x25 window. Recurring noise has many bright pixels in the window, so it stays.
/// @tparam Inner a BlendPolicy that keeps the history length, such as RunningMean
template <class Inner> struct ForgetBiased {
    static_assert(BlendPolicy<Inner>, "ForgetBiased{inner}: `inner` must have blend(px, past), see quell/blend/blend_policy.hpp");
    using parts = Parts<Inner>;
    using reads = Channels<HistoryBias, HistoryDeviation>;
    static constexpr int farthest_tap = 0;
    static_assert(keeps_of<Inner>::template has<HistoryLength>,
                  "ForgetBiased{inner}: `inner` must keep the history's length, as RunningMean does");
    Inner inner{};                ///< blends with the reduced validity
    float gain = 100.f;           ///< by how much later filters reduce the variance
    float firefly_share = 0.125f; ///< in (0, 1]; 1: no history is forgotten as a firefly

    /// The inner policy's result with the reduced validity.
    QUELL_KERNEL auto blend(auto px, auto past) const {
        using Real = typename decltype(px)::Real;
        auto const then = luminance(past.signal), brighter = max(then - luminance(px.signal()), Real(0.f)), around = px[history_deviation];
        // 1/1000 of the light may be rounding or interpolation.
        auto const usual = fma(around * around, Real(detail::wide_window * firefly_share), then * then * 1e-6f);
        past.validity = masked(brighter * brighter <= usual, past.validity);
        auto const frames = past[history_length] / px.samples() + 1.f;
        past.validity = past.validity / fma(px[history_bias] * gain, frames, Real(1.f));
        return inner.blend(px, past);
    }
};
template <class Inner> ForgetBiased(Inner) -> ForgetBiased<Inner>;

} // namespace quell::inline QUELL_INSTRUCTION_SET
