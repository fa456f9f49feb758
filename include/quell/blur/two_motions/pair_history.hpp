#pragma once

#include <quell/blend/blend_policy.hpp>
#include <quell/blur/layer_hull.hpp>
#include <quell/blur/path_search.hpp>
#include <quell/blur/two_motions/pair_gather.hpp>
#include <quell/motion/catmull_rom.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {
/// A place that a motion source found, whose taps must also have seen the layer.
/// @tparam Layer a channel whose last component is the number of samples
template <ChannelTag Layer, class FoundPlace> struct WhereSeen : FoundPlace {
    QUELL_KERNEL auto accepts(auto const& then, auto dx, auto dy) const {
        auto const samples = weight_of(then[Layer{}]);
        return both(samples > decltype(samples)(0.f), FoundPlace::accepts(then, dx, dy));
    }
};
} // namespace detail

/// History fetch for a foreground and a background layer: the background's from where the motion source says, the foreground's from where
/// `front` says. Layers of many samples are smooth and hardly need a past: bilinear interpolation does for them.
/// @tparam S the pipeline's signal
template <ChannelTag S> struct PairFetch {
    using Signal = S;
    using reads = Channels<ForegroundLayer<Signal>, ForegroundSweep, BackgroundLayer<Signal>>;
    static constexpr int farthest_tap = 0;
    PathSearchOf<ForegroundSweep> front{}; ///< motion source of the foreground layer
    /// Samples in a frame. A layer of fewer has its past interpolated by a Catmull-Rom spline; a foreground of more or as many has no past.
    float often = 10.f;

    template <class Px, class Found> QUELL_KERNEL auto fetch(Px const& px, Found const& unchecked) const {
        constexpr BackgroundLayer<Signal> back;
        // The rest of the past is needed only where samples are missing.
        auto past = any(px.missing()) ? Bilinear{.use_3x3 = false}.fetch(px, unchecked) : detail::no_past<Px>();
        detail::WhereSeen<BackgroundLayer<Signal>, Found> const found{detail::sane(px, unchecked)};
        auto const known = interpolated(px, found, back);
        past.where = found.where;
        past.validity = masked(known.accepted, found.validity);
        // A static pixel keeps its value bit by bit.
        auto const seldom =
            both(known.accepted, invert(found.still), detail::weight_of(px[back]) < real_of<decltype(past.validity)>(often));
        past.kept.set(back, sharpened<detail::Hull>(px, found, seldom, known.value, back));
        past.kept.set(ForegroundLayer<Signal>{}, past_front(px));
        return past;
    }

private:
    /// 0, with no samples, where it has no past.
    template <class Px> QUELL_KERNEL auto past_front(Px const& px) const {
        using Real = typename Px::Real;
        constexpr ForegroundLayer<Signal> layer;
        auto const samples = detail::weight_of(px[layer]);
        auto const seldom = both(samples > Real(0.f), samples < Real(often));
        if (!any(seldom)) return zero<Value<layer.components, Real>>();
        detail::WhereSeen<ForegroundLayer<Signal>, decltype(front.previous(px))> found{front.previous(px)};
        found.validity = masked(seldom, found.validity);
        auto const known = interpolated(px, found, layer);
        return sharpened<detail::LayerHull>(px, found, known.accepted, known.value, layer);
    }
    template <class Layer> QUELL_KERNEL static auto interpolated(auto const& px, auto const& found, Layer) {
        return Bilinear::interpolated(px, found, [](auto const& then) QUELL_INLINED { return then[Layer{}]; });
    }
    /// Catmull-Rom interpolation where wanted; the number of samples stays.
    template <template <class> class Limits, class Px, class Found, class Mask, class V, class Layer>
    QUELL_KERNEL static V sharpened(Px const& px, Found const& found, Mask wanted, V const& smooth, Layer) {
        if (!any(wanted)) return smooth;
        auto const spline = CatmullRom::interpolated<Limits>(
            px, found, detail::signal_of(smooth), [](auto const& then) QUELL_INLINED { return detail::signal_of(then[Layer{}]); });
        return select(wanted, detail::layer_of(spline, detail::weight_of(smooth)), smooth);
    }
};

/// Blend policy: accumulates the foreground and the background layer separately and composites them. Means are weighted by samples, not by
/// frames: fast motion has many samples within a frame and does not need the history, which is less sharp; slow motion needs it. A static
/// background keeps its value while it is seen, and is remembered while it is covered.
/// @tparam S the pipeline's signal
template <ChannelTag S> struct PairBlend {
    using Signal = S;
    using reads = Channels<ForegroundLayer<Signal>, ForegroundSweep, BackgroundLayer<Signal>, MeanSweep>;
    using keeps = reads;
    static constexpr int farthest_tap = 0;
    float cap = 6.f; ///< samples that the background's past counts as, at most
    /// The same of the foreground: fewer, since its parts move differently, and a lagging outline is more visible than its noise.
    float front_cap = 4.f;
    /// Pixels, above 0: shorter sweeps lower both limits in proportion. They have less noise, and interpolation softens them as often.
    float slow = 2.5f;
    /// Shutter, above 0: a shorter one lowers the foreground's limit in proportion. The less of its path a sweep shows, the less it tells
    /// where the foreground was a frame ago.
    float short_shutter = 0.25f;

    /// Of the background. Once over, since layers leave the image.
    [[nodiscard]] constexpr BlendMemory memory() const { return {.frames = cap, .times = 1.f}; }

    template <class Px, class P> QUELL_KERNEL auto blend(Px const& px, P const& past) const {
        using Real = typename Px::Real;
        constexpr ForegroundLayer<Signal> front;
        constexpr BackgroundLayer<Signal> back;
        auto const back_sweep = px[mean_sweep];
        auto const still = both(back_sweep.x == Real(0.f), back_sweep.y == Real(0.f));
        auto const samples = detail::weight_of(px[back]), known = detail::weight_of(past[back]);
        auto const counted = min(known, select(still, known, at_most(cap, back_sweep)));
        auto const share = select(still, masked(samples >= known, Real(1.f)), share_of(samples, counted));
        auto const behind = joined(past[back], px[back], share, select(still, max(samples, known), samples + counted));

        auto const front_samples = detail::weight_of(px[front]),
                   front_counted = min(detail::weight_of(past[front]),
                                       at_most(front_cap * min(px.shutter_now() / short_shutter, 1.f), px[foreground_sweep]));
        auto const in_front = joined(past[front], px[front], share_of(front_samples, front_counted), front_samples + front_counted);
        auto const covering = detail::covering(detail::signal_of(in_front));
        return Result{detail::layers_together(covering, behind, px.signal()), share}
            .with(front, in_front)
            .with(foreground_sweep, px[foreground_sweep])
            .with(back, behind)
            .with(mean_sweep, back_sweep);
    }

private:
    /// Limit of the samples that a layer's past counts as, by its sweep.
    template <class Real> QUELL_KERNEL Real at_most(auto maximum, vec2<Real> const& of_layer) const {
        return min(sqrt(fma(of_layer.x, of_layer.x, of_layer.y * of_layer.y)) * (maximum / slow), Real(maximum));
    }
    /// Share of this frame's samples in the mean.
    template <class Real> QUELL_KERNEL static Real share_of(Real samples, Real past) {
        return select(past > Real(0.f), samples / max(samples + past, Real(1e-6f)), Real(1.f));
    }
    template <class L, class Real> QUELL_KERNEL static L joined(L const& then, L const& now, Real share, Real samples) {
        auto const signal = mix(detail::signal_of(then), detail::signal_of(now), share);
        return detail::layer_of(select(share >= Real(1.f), detail::signal_of(now), signal), samples);
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
