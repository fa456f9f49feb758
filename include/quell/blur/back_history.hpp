#pragma once

#include <quell/blend/blend_policy.hpp>
#include <quell/blur/pair_gather.hpp>
#include <quell/motion/catmull_rom.hpp>

namespace quell {

/// History of what is behind: by a Catmull-Rom spline where every pixel of the past moves as it should.
/// @tparam S the pipeline's signal
template <ChannelTag S> struct BackFetch {
    using Signal = S;
    bool sharp = true; ///< false: bilinear, which blurs a little more in each frame

    template <class Px, class Found> QUELL_KERNEL auto fetch(Px const& px, Found const& found) const {
        constexpr BackLayer<Signal> back;
        auto past = Bilinear{.rescue = false}.fetch(px, found);
        // What stands still is where it was, to the last bit.
        auto const between = both(past.validity > real_of<decltype(past.validity)>(0.f), invert(found.still));
        if (sharp && any(between)) {
            auto const spline = CatmullRom::interpolated(
                px, found, between,
                [](auto const& then) __attribute__((always_inline)) { return detail::signal_of(then[BackLayer<Signal>{}]); });
            auto const smooth = past.kept[back];
            past.kept.set(back, select(spline.accepted, detail::layer_of(spline.value, detail::weight_of(smooth)), smooth));
        }
        return past;
    }
};

/// Accumulates what is behind, and puts what is in front over it. A mean counts the samples that it is made of, not frames: fast motion
/// passes many samples within one frame and needs no history, which is never as sharp; slow motion needs it. What stands still keeps its
/// value while it is seen, and is remembered while it is covered.
template <ChannelTag S> struct BackBlend {
    using Signal = S;
    using reads = Channels<MovingLayer<Signal>, BackLayer<Signal>, MeanSweep>;
    using keeps = Channels<BackLayer<Signal>, MeanSweep>;
    float cap = 16.f; ///< samples that the past counts as, at most

    template <class Px, class P> QUELL_KERNEL auto blend(Px const& px, P const& past) const {
        using Real = typename Px::Real;
        constexpr BackLayer<Signal> back;
        auto const sweep = px[mean_sweep];
        auto const still = both(sweep.x == Real(0.f), sweep.y == Real(0.f));
        auto const now = px[back], then = past[back];
        auto const samples = detail::weight_of(now), known = masked(past.validity > Real(0.f), detail::weight_of(then));
        auto const counted = min(known, select(still, known, Real(cap)));
        auto const both_counted = samples + counted;
        auto const share = select(still, masked(samples >= known, Real(1.f)),
                                  select(both_counted > Real(0.f), samples / max(both_counted, Real(1e-6f)), Real(1.f)));
        auto const signal = mix(detail::signal_of(then), detail::signal_of(now), share);
        auto const layer =
            detail::layer_of(select(share >= Real(1.f), detail::signal_of(now), signal), select(still, max(samples, known), both_counted));
        return Result{detail::layers_together(px[MovingLayer<Signal>{}], layer, px.signal()), share}
            .with(back, layer)
            .with(mean_sweep, sweep);
    }
};

} // namespace quell
