#pragma once

#include <quell/core/light.hpp>
#include <quell/core/logarithm.hpp>
#include <quell/link/checkerboard.hpp>
#include <quell/link/frame_brightness.hpp>
#include <quell/link/window.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// How far samples may be from a picture of them: noise of few bright samples is skewed.
struct ResidualLimits {
    float most = 20.f;  ///< samples are at most so many times the picture's luminance
    float dark = 0.02f; ///< part of the frame's mean luminance that is added to that
    float spike = 3.f;  ///< a residual is at most so many times the root mean square around; what is more is spread there
};

namespace detail {

/// Samples minus picture, in units of the frame's brightness, and 1 where there is a sample; else all are 0.
struct SampleResidual : ExactChannel<4> {
    static constexpr auto name = "residual";
};
/// The square of the residual, and 1 where there is a sample; summed along rows in another channel.
struct ResidualSquares : ExactChannel<2> {
    static constexpr auto name = "residual_squares";
};
struct ResidualSquaresOfRows : ExactChannel<2> {
    static constexpr auto name = "residual_squares_of_rows";
};
/// The mean square of the residual around a pixel, and of a hundredth of the picture's luminance.
struct MeanSquare : ExactChannel<1> {
    static constexpr auto name = "mean_square";
};
/// What a residual is too much, and 1 where there is a sample.
struct Spikes : ExactChannel<4> {
    static constexpr auto name = "spikes";
};
/// Luminance of the picture, whatever its sign: summed along rows.
struct RowBrightness : ExactChannel<1> {
    static constexpr auto name = "row_brightness";
};
/// The picture's light around a pixel, and a little of that of the frame.
struct LightAround : ExactChannel<1> {
    static constexpr auto name = "light_around";
};

inline constexpr int light_radius = 2;          ///< of the squares that light_around is taken over
inline constexpr int residual_noise_radius = 3; ///< of those of mean_square, and that spikes are spread over

/// The colour of a channel whose last component is something else.
template <class V> QUELL_KERNEL vec3<real_of<V>> colour_of(V const& v) { return {v.x, v.y, v.z}; }
template <class Real> QUELL_KERNEL Value<4, Real> with_last(vec3<Real> const& colour, Real last) {
    return {colour.x, colour.y, colour.z, last};
}

/// How bright the picture is, in units of the frame's brightness.
template <class Px> QUELL_KERNEL auto brightness(Px const& px) { return abs(luminance(px.signal())) / frame_brightness(px); }

/// Sums brightness along rows.
struct SumBrightnessOfRows {
    static constexpr auto name = "light around, rows";
    using reads = FrameBrightness::whole;
    using emits = Channels<RowBrightness>;
    static constexpr int farthest_tap = light_radius;

    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        Real sum(0.f);
        for (int i = -light_radius; i <= light_radius; ++i) {
            auto const tap = px.at(i, 0);
            sum = sum + masked(tap.inside(), abs(luminance(tap.signal())));
        }
        return emitted<Real>(RowBrightness{}, sum / frame_brightness(px));
    }
};
/// The picture's light around a pixel, of those sums.
template <class Px> QUELL_KERNEL auto light_around(Px const& px) {
    return sum_along_column(px, RowBrightness{}, light_radius) / pixels_in_window(px, light_radius) + (.02f + 1e-6f);
}

/// Takes the residual.
/// @tparam Samples the channel that the picture was made of
template <ChannelTag Samples> struct TakeResidual {
    static constexpr auto name = "residual";
    using reads = union_of<Channels<Samples>, FrameBrightness::whole>;
    using emits = Channels<SampleResidual, ResidualSquares>;
    static constexpr int farthest_tap = 0;
    ResidualLimits limits;

    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const sample = px[Samples{}];
        auto const picture = px.signal();
        auto const per_unit = 1.f / frame_brightness(px);
        auto const most = (abs(luminance(picture)) * per_unit + (limits.dark + 1e-6f)) * limits.most;
        auto const off = map([&](Real s, Real p) QUELL_INLINED { return min(s * per_unit, most) - p * per_unit; }, sample, picture);
        auto const is_known = both(is_light(sample), invert(px.missing()), all_finite(off));
        auto const known = masked(is_known, Real(1.f));
        auto const value = map([&](Real a) QUELL_INLINED { return masked(is_known, a); }, off);
        return emitted<Real>(SampleResidual{}, with_last(value, known)).with(ResidualSquares{}, vec2<Real>{dot(value, value), known});
    }
};

/// Finds what residuals are too much beside the root mean square around.
struct LimitResidual {
    static constexpr auto name = "limit residual";
    using reads = union_of<Channels<SampleResidual, ResidualSquaresOfRows>, FrameBrightness::whole>;
    using emits = Channels<SampleResidual, Spikes, MeanSquare>;
    static constexpr int farthest_tap = residual_noise_radius;
    ResidualLimits limits;

    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const around = sum_along_column(px, ResidualSquaresOfRows{}, residual_noise_radius);
        auto const light = brightness(px) + (limits.dark + 1e-6f);
        auto const mean = around.x / max(around.y, Real(1.f)) + light * light * 1e-4f;
        auto const whole = px[SampleResidual{}];
        auto const value = colour_of(whole);
        auto const limit = mean * (limits.spike * limits.spike), square = dot(value, value);
        auto const kept = scale(value, select(square > limit, sqrt(limit / max(square, Real(1e-37f))), Real(1.f)));
        return emitted<Real>(SampleResidual{}, with_last(kept, whole.w))
            .with(Spikes{}, with_last(value - kept, whole.w))
            .with(MeanSquare{}, mean);
    }
};

/// The residual with what was too much spread over pixels of each one's half of the checkerboard, so that the mean stays and the halves
/// know nothing of each other.
template <class Px> QUELL_KERNEL auto with_spikes_spread(Px const& px) {
    using Real = typename Px::Real;
    constexpr int radius = residual_noise_radius;
    auto sum = zero<Value<4, Real>>();
    for (int j = -radius; j <= radius; ++j)
        for (int i = -radius + (radius + j) % 2; i <= radius; i += 2) {
            auto const tap = px.at(i, j);
            sum = add_scaled(sum, tap[Spikes{}], masked(tap.inside(), Real(1.f)));
        }
    auto const own = px[SampleResidual{}];
    return with_last(add_scaled(colour_of(own), colour_of(sum), own.w / max(sum.w, Real(1.f))), own.w);
}

/// Passes up to the last, which spreads the spikes.
template <ChannelTag Samples> struct LimitedResidual {
    using parts = Parts<TakeResidual<Samples>, SumRows<ResidualSquares, ResidualSquaresOfRows>, LimitResidual>;
    ResidualLimits limits;

    constexpr void for_each_pass(auto&& pass) const {
        pass(TakeResidual<Samples>{limits});
        pass(SumRows<ResidualSquares, ResidualSquaresOfRows>{residual_noise_radius});
        pass(LimitResidual{limits});
    }
};

} // namespace detail

} // namespace quell::inline QUELL_INSTRUCTION_SET
