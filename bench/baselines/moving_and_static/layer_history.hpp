#pragma once

#include <baselines/moving_and_static/layers.hpp>

#include <quell/blend/blend_policy.hpp>
#include <quell/blur/layer_hull.hpp>
#include <quell/motion/catmull_rom.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// History fetch for two layers: the moving one from where the motion source says, the static one from the same pixel.
/// @tparam S the pipeline's signal
template <ChannelTag S> struct LayerFetch {
    static constexpr int farthest_tap = 0;
    using Signal = S;
    bool sharp = true; ///< Catmull-Rom interpolation of the moving layer; false: bilinear, which blurs a little more in each frame

    template <class Px, class Found> QUELL_KERNEL auto fetch(Px const& px, Found const& found) const {
        using Real = typename Px::Real;
        constexpr MovingLayer<Signal> moving;
        constexpr StaticLayer<Signal> still;
        auto past = Bilinear{}.fetch(px, found);
        if (auto const valid = past.validity > Real(0.f); sharp && any(valid)) {
            auto const spline = CatmullRom::interpolated<detail::LayerHull>(
                px, found, past.kept[moving], [](auto const& then) QUELL_INLINED { return then[MovingLayer<Signal>{}]; });
            past.kept.set(moving, select(valid, spline, past.kept[moving]));
        }
        auto const p = px.position();
        PixelCoordinates<Real> const here(p.x - 0.5f, p.y - 0.5f);
        past.kept.set(still, px.past(here)[still]);
        return past;
    }
};

/// Blend policy: accumulates both layers separately and composites them. The moving layer is a running mean of coverage and of signal times
/// coverage. The static layer keeps its value while it is seen, and is remembered while it is covered.
/// @tparam S the pipeline's signal
template <ChannelTag S> struct LayerBlend {
    using Signal = S;
    using reads = Channels<MovingLayer<Signal>, StaticLayer<Signal>, MeanSweep>;
    using keeps = Channels<MovingLayer<Signal>, StaticLayer<Signal>, MeanSweep, HistoryLength>;
    static constexpr int farthest_tap = 0;
    float cap = 8.f; ///< frames that the moving layer averages at most; at least 1

    /// Of the moving layer. Once over, since layers leave the image.
    [[nodiscard]] constexpr BlendMemory memory() const { return {.frames = cap, .times = 1.f}; }

    template <class Px, class P> QUELL_KERNEL auto blend(Px const& px, P const& past) const {
        using Real = typename Px::Real;
        constexpr MovingLayer<Signal> moving;
        constexpr StaticLayer<Signal> still;
        auto const length = min(masked(past.validity > Real(0.f), past[history_length]) + 1.f, Real(cap));
        auto const alpha = 1.f / length;
        auto const layer = mix(past[moving], px[moving], alpha);
        auto const seen = px[still], remembered = past[still];
        auto const background = select(detail::weight_of(remembered) > detail::weight_of(seen), remembered, seen);
        return Result{detail::layers_together(layer, background, px.signal()), alpha}
            .with(moving, layer)
            .with(still, background)
            .with(mean_sweep, px[mean_sweep])
            .with(history_length, length);
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
