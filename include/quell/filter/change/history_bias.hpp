#pragma once

#include <quell/blend/variance_over_time.hpp>
#include <quell/filter/change/light_change.hpp>

namespace quell {

/// How wrong the history is for the light of now: the square of its bias over the variance of one sample. 0 where there is no evidence.
struct HistoryBias : MadeChannel<1> {
    static constexpr auto name = "history_bias";
};
inline constexpr HistoryBias history_bias;

// What BiasEstimate measures, as means over a window. Four channels and not one of four components: their memory serves other passes later.

/// Luminance now less luminance of the history.
struct HistoryDistance : MadeChannel<1> {
    static constexpr auto name = "history_distance";
};
/// Root mean square of that.
struct HistoryDeviation : MadeChannel<1> {
    static constexpr auto name = "history_deviation";
};
/// The root mean square that the history's own variance makes one expect.
struct ExpectedDeviation : MadeChannel<1> {
    static constexpr auto name = "expected_deviation";
};
/// The part of the window that has a history.
struct HistoryShare : MadeChannel<1> {
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

/// The measurements of one pixel: nothing where there is no past or no sample.
template <class Source> struct OwnHistoryDistance {
    static constexpr auto name = "history distance";
    using parts = Parts<Source>;
    using reads_kept = Channels<HistoryLength, LuminanceVariance>;
    using emits = WindowChannels;
    Source source;

    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        Real const none(0.f);
        if (!px.has_past()) return WindowOfHistory<Real>{none, none, none, none}.emitted();
        auto const [past, distance, known] = beside_past(px, source);
        auto const n = max(past[history_length], Real(1e-3f)), now = px.samples();
        auto const of_sample = masked(n > Real(1.f), unbiased_variance(past[luminance_variance], n));
        // Less than a thousandth of the light may be rounding, or interpolation of a picture without noise.
        auto const light_then = luminance(past.signal);
        auto const expected = fma(light_then * light_then, Real(1e-6f), of_sample * (1.f / now + 1.f / n));
        auto const usable = both(known, is_finite(expected));
        return WindowOfHistory<Real>{masked(usable, distance), masked(usable, abs(distance)), masked(usable, sqrt(expected)),
                                     masked(usable, Real(1.f))}
            .emitted();
    }
};

/// Puts together five in a row or a column. Outside the image there is nothing.
struct HistoryDistanceLine {
    static constexpr auto name = "history distance";
    using reads = WindowChannels;
    using emits = WindowChannels;
    int step;
    bool vertical;

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

inline constexpr float wide_window = 625.f; ///< pixels

/// The evidence of one window: how far the mean distance lies beyond what noise explains, squared, over the noise.
template <class Real> QUELL_KERNEL Real bias_in(WindowOfHistory<Real> const& window, float pixels, float by_chance) {
    auto const share = 1.f / max(window.share, Real(1e-6f));
    auto const mean = window.distance * share;
    // Skewed noise looks like change where its rare bright samples are missing from a window; the history has seen them.
    auto const seen = fma(window.deviation, window.deviation * share, -mean * mean);
    auto const expected = window.expected * window.expected * share;
    auto const noise = max(max(seen, expected), Real(1e-20f));
    auto const count = max(window.share * pixels - 1.f, Real(0.5f));
    auto const excess = max(fma(mean, mean, -(noise * by_chance) / count), Real(0.f));
    return min(excess / noise, Real(1e6f));
}

/// The last step of the narrow window, which is the first of the wide one: columns of it put together, and what it says.
struct NarrowBias {
    static constexpr auto name = "history bias";
    using reads = WindowChannels;
    using emits = decltype(WindowChannels{} | Channels<HistoryBias>{});
    float by_chance;

    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        return HistoryDistanceLine{5, false}.mean(px).emitted().with(history_bias, bias_in<Real>(window_at(px), 25.f, by_chance));
    }
};
struct WideBias {
    static constexpr auto name = "history bias";
    using reads = decltype(WindowChannels{} | Channels<HistoryBias>{});
    using emits = Channels<HistoryBias, HistoryDeviation>;
    float by_chance;

    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const wide = HistoryDistanceLine{5, true}.mean(px);
        return emitted<Real>(history_bias, max(px[history_bias], bias_in<Real>(wide, wide_window, by_chance)))
            .with(history_deviation, wide.deviation);
    }
};
} // namespace detail

/// Measures how far the history lies from the light of now, where light moves or changes though no motion vector says so: in many pixels
/// together the noise cancels that hides it in one. Two windows, of 5x5 and of 25x25 pixels: the narrow one sees sharply what is clear, the
/// wide one what is faint. Goes before a Temporal{..., WithVariance{ForgetBiased{RunningMean{}}}}.
/// @tparam Source a MotionSource
template <class Source = SurfaceMotion<SameDepth>> struct BiasEstimate {
    using Own = detail::OwnHistoryDistance<Source>;
    using parts = Parts<Own, detail::NarrowBias, detail::WideBias>;
    static constexpr bool leaves_signal = true;
    Source source{};
    float narrow_by_chance = 9.f; ///< variances of a window's mean that noise alone explains, for 5x5 pixels
    float wide_by_chance = 1.f;   ///< for 25x25

    constexpr void for_each_pass(auto&& pass) const {
        pass(Own{source});
        pass(detail::HistoryDistanceLine{1, false});
        pass(detail::HistoryDistanceLine{1, true});
        pass(detail::NarrowBias{narrow_by_chance});
        pass(detail::WideBias{wide_by_chance});
    }
};

/// Shortens a history by as much as it is wrong. A history of n samples has the mean square error variance / n + bias^2; it counts as if
/// it had the n' of variance / n', after the spatial filter has taken the variance down by `gain` and left the bias as it is:
///     n' = n / (1 + gain (n / now + 1) bias^2 / variance)
/// where bias^2 / variance comes from a BiasEstimate. Decorates a policy that keeps the history's length.
/// A firefly is forgotten at once: a pixel whose history alone is brighter than the light of now, by more than `firefly_share` of all the
/// squared differences in the wide window. Noise that comes back has more such pixels in a window, and stays.
template <class Inner> struct ForgetBiased {
    static_assert(BlendPolicy<Inner>, "ForgetBiased{inner}: `inner` must have blend(px, past), see quell/blend/blend_policy.hpp");
    using parts = Parts<Inner>;
    using reads = Channels<HistoryBias, HistoryDeviation>;
    static_assert(keeps_of<Inner>::template has<HistoryLength>,
                  "ForgetBiased{inner}: `inner` must keep the history's length, as RunningMean does");
    Inner inner{};
    float gain = 100.f;           ///< by how much the filters behind this reduce variance
    float firefly_share = 0.125f; ///< in (0, 1]; 1: no history is forgotten as a firefly

    QUELL_KERNEL auto blend(auto px, auto past) const {
        using Real = typename decltype(px)::Real;
        auto const then = luminance(past.signal), brighter = max(then - luminance(px.signal()), Real(0.f)), around = px[history_deviation];
        // A thousandth of the light may be rounding, or interpolation.
        auto const usual = fma(around * around, Real(detail::wide_window * firefly_share), then * then * 1e-6f);
        past.validity = masked(brighter * brighter <= usual, past.validity);
        auto const frames = past[history_length] / px.samples() + 1.f;
        past.validity = past.validity / fma(px[history_bias] * gain, frames, Real(1.f));
        return inner.blend(px, past);
    }
};
template <class Inner> ForgetBiased(Inner) -> ForgetBiased<Inner>;

} // namespace quell
