#pragma once

#include <quell/link/residual/finest_band.hpp>
#include <quell/link/residual/residual_feedback_shares.hpp>
#include <quell/link/residual/shared_noise.hpp>

#include <optional>

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {

/// The same as of a band, of all that the levels give.
struct LevelProducts : ExactChannel<3> {
    static constexpr auto name = "level_products";
};
struct LevelProductsOfRows : ExactChannel<3> {
    static constexpr auto name = "level_products_of_rows";
};
/// The logarithm of the light around along rows: the sum, and the sum of squares.
struct TextureOfRows : ExactChannel<2> {
    static constexpr auto name = "texture_of_rows";
};
/// What the levels give.
struct LevelsGiven : ExactChannel<3> {
    static constexpr auto name = "levels_given";
};

inline constexpr int texture_radius = 4; ///< of windows, in pixels

/// Takes logarithms of the picture's light.
struct TakeLight {
    static constexpr auto name = "light around";
    using reads = union_of<Channels<RowBrightness>, FrameBrightness::whole>;
    using emits = Channels<LightAround, LightLogarithms>;
    static constexpr int farthest_tap = light_radius;

    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const around = light_around(px);
        auto const own = max(luminance(px.signal()), Real(0.f)) / frame_brightness(px);
        return emitted<Real>(LightAround{}, around)
            .with(LightLogarithms{}, vec2<Real>{logarithm(fma(around, Real(.05f), own)), logarithm(around)});
    }
};

/// Spreads spikes, and sets out the halves of the residual.
struct SetOutHalves {
    static constexpr auto name = "spread spikes";
    using reads = Channels<SampleResidual, Spikes, LightLogarithms>;
    using emits = Channels<SampleResidual, FirstHalf, SecondHalf, TextureOfRows>;
    static constexpr int farthest_tap = texture_radius;

    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const residual = with_spikes_spread(px);
        auto const is_second = checkerboard_half(px) > Real(0.5f);
        auto const none = zero<Value<4, Real>>();
        auto texture = zero<vec2<Real>>();
        for (int i = -texture_radius; i <= texture_radius; ++i) {
            auto const tap = px.at(i, 0);
            auto const its = masked(tap.inside(), tap.template channel_component<1>(LightLogarithms{}));
            texture = {texture.x + its, fma(its, its, texture.y)};
        }
        return emitted<Real>(SampleResidual{}, residual)
            .with(FirstHalf{}, select(is_second, none, residual))
            .with(SecondHalf{}, select(is_second, residual, none))
            .with(TextureOfRows{}, texture);
    }
};

/// Puts together what the levels give.
struct GiveLevels {
    static constexpr auto name = "levels";
    using reads = Channels<FirstHalf, SecondHalf, FinestBand, FinestBandOfOthers, BandProductsOfRows, TextureOfRows, LightAround,
                           MeanSquare, SampleResidual>;
    using emits = Channels<LevelsGiven, LevelProducts>;
    static constexpr int farthest_tap = band_radius;
    ResidualFeedbackShares first, later; ///< of frames without a past, and of those with one
    float most;                          ///< what is added of each part is at most so many times the light around

    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const by = px.has_past() ? later : first;
        auto const light = px[LightAround{}], limit = light * most;
        auto const noise = noise_of(sqrt(px[MeanSquare{}] * (1.f / 3.f)) / light);
        // No frequency is fed back more than whole.
        auto const finest = min(surely_held(px) * by.fine_held, Real(1.f));
        auto const wide = min(fma(noise, Real(by.wide_noise), fma(texture_of(px), Real(by.wide_texture), Real(by.wide))), Real(1.f));
        auto const part = [&](Real share, Real a) QUELL_INLINED { return masked(is_finite(a), share * clamp(a, -limit, limit)); };
        auto const of_levels = [&](Real band, Real widest) QUELL_INLINED { return part(finest, band) + part(wide, widest); };
        auto const given = map(of_levels, px[FinestBand{}], smoothed(px));
        auto const of_others = map(of_levels, px[FinestBandOfOthers{}], smoothed_of_others(px));
        return emitted<Real>(LevelsGiven{}, given).with(LevelProducts{}, products(px, given, of_others));
    }

private:
    /// N of ResidualFeedbackShares.
    template <class Real> QUELL_KERNEL static Real noise_of(Real relative) {
        constexpr float per_octave = 1.44269504f;
        return clamp(logarithm(relative + 1e-3f) * (per_octave / 3.f), Real(-2.f), Real(1.5f));
    }
    /// How much light varies around the pixel: twice its logarithm's standard deviation, to 1.5.
    template <class Px> QUELL_KERNEL static auto texture_of(Px const& px) {
        using Real = typename Px::Real;
        auto const sums = sum_along_column(px, TextureOfRows{}, texture_radius);
        auto const per_pixel = 1.f / pixels_in_window(px, texture_radius), mean = sums.x * per_pixel;
        return min(2.f * sqrt(max(sums.y * per_pixel - mean * mean, Real(0.f))), Real(1.5f));
    }
};

/// Adds what the levels give, as far as samples that were held out bear it out.
template <bool reports> struct AddLevels {
    static constexpr auto name = "residual feedback";
    using reads =
        union_of<Channels<LevelsGiven, LevelProductsOfRows>, FrameBrightness::whole, typename FindSharedNoise<SampleResidual>::whole>;
    using keeps = std::conditional_t<reports, Channels<NoiseIndependence>, Channels<>>;
    int radius;
    float variance, darkest;

    constexpr int farthest_tap() const { return radius; }

    QUELL_KERNEL auto filter(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const sums = sum_along_column(px, LevelProductsOfRows{}, radius);
        auto const trust = independence(px);
        // Where the levels give nothing, nothing is known of w. The product of two samples is in the sum once for each of them.
        auto const whole = sums.y + 1e-15f, doubt = fma(sums.z, Real(2.f / variance), Real(1e-20f)) / (whole * whole);
        auto const w = clamp((sums.x / whole + doubt) / (1.f + doubt), Real(0.f), Real(1.f)) * trust * frame_brightness(px);
        auto const made =
            map([&](Real a, Real b) QUELL_INLINED { return max(fma(b, w, a), min(a, a * darkest)); }, px.signal(), px[LevelsGiven{}]);
        if constexpr (reports)
            return Result{made}.with(NoiseIndependence{}, trust);
        else
            return made;
    }
};

} // namespace detail

/// Gives back to a denoised picture what its filter took out by mistake, by shares that were fitted to renders: see
/// ResidualFeedbackShares. It is a kind of twicing (Tukey 1977, "Exploratory Data Analysis").
///
///     Chain{presets::general(radiance), Pipeline{denoised, Spatial{ResidualFeedback<Radiance>{.samples = 16.f}}}}
///
/// The residual, samples minus picture, is smoothed over surfaces and over pieces of like light, in four levels with steps of 1, 2, 4 and 8
/// pixels. A part of the widest level and of the finest band between levels is added; nothing of the pixel's own residual, which is noise
/// first. How much of the level depends on the noise and on the light's texture, how much of the band on what samples that were held out
/// have in common with it: with B the band at even pixels, made of the residual r at odd ones, and the other way round as on a
/// checkerboard, sum r B / sum B^2 over a window.
///
/// Shares that were fitted to other renders may be wrong for this one. So all of it comes back by the part w that samples bear out: with A
/// what the levels give and H the same of held-out samples, w = sum r H / sum A^2 over a window. Before any sample is seen, w is 1 with
/// variance `held_variance`; sum r H has the variance 2 sum (r H)^2; w is the mean after both, from 0 to 1.
/// @tparam Samples the channel of three components that the picture was made of, linear
/// @tparam reports whether the history keeps noise_independence
template <ChannelTag Samples = Radiance, bool reports = false> struct ResidualFeedback {
    float samples = 1.f;    ///< of each pixel; shares lie between those of 1 and of 16
    bool is_judged = false; ///< whether samples have chosen, for each pixel, between a picture with history and one without
    std::optional<ResidualFeedbackShares>
        shares{};                ///< of all frames; none: those fitted for `samples` and, behind history, beside_history()
    float most = 3.f;            ///< what is added of each part is at most so many times the light around
    float darkest = 0.2f;        ///< of the picture's light so much stays at least
    float held_variance = 3.f;   ///< of w, as it is known before; above 0
    ResidualLimits limits{};     ///< of the residual
    SharedNoise of_neighbours{}; ///< where neighbours share their noise, less is added, or nothing
    /// @cond
    using Differences = detail::SampleResidual;
    using parts = Parts<detail::FrameBrightness, detail::LimitedResidual<Samples>, detail::FindSharedNoise<Differences>,
                        detail::SumBrightnessOfRows, detail::TakeLight, detail::SetOutHalves, detail::SmoothHalves, detail::TakeFinestLevel,
                        detail::TakeFinestBand, detail::SumRows<detail::BandProducts, detail::BandProductsOfRows>, detail::GiveLevels,
                        detail::SumRows<detail::LevelProducts, detail::LevelProductsOfRows>, detail::AddLevels<reports>>;
    /// @endcond

    /// Its passes.
    constexpr void for_each_pass(auto&& pass) const {
        using namespace detail;
        constexpr int held_radius = 16; // of the windows that w is taken over
        FrameBrightness{}.for_each_pass(pass);
        LimitedResidual<Samples>{limits}.for_each_pass(pass);
        FindSharedNoise<Differences>{of_neighbours}.for_each_pass(pass);
        pass(SumBrightnessOfRows{}), pass(TakeLight{}), pass(SetOutHalves{});
        pass(SmoothHalves{1}), pass(TakeFinestLevel{});
        pass(SmoothHalves{2}), pass(TakeFinestBand{});
        pass(SumRows<BandProducts, BandProductsOfRows>{band_radius});
        pass(SmoothHalves{4}), pass(SmoothHalves{8});
        auto const alone = shares.value_or(ResidualFeedbackShares::of_samples(samples));
        bool const is_steady = !shares && !is_judged;
        pass(GiveLevels{alone, is_steady ? ResidualFeedbackShares::beside_history(samples) : alone, most});
        pass(SumRows<LevelProducts, LevelProductsOfRows>{held_radius});
        pass(AddLevels<reports>{held_radius, held_variance, darkest});
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
