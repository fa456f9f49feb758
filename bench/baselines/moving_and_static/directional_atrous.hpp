#pragma once

#include <baselines/moving_and_static/path_weight.hpp>
#include <baselines/pixel_under.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {
/// One level of the wavelet.
/// @tparam From the channel of the moving layer that it starts from
template <ChannelTag S, ChannelTag From> struct DirectionalLevel {
    using Signal = S;
    static constexpr auto name = "directional a-trous";
    static constexpr int taps_along = 2; ///< to either side: MB's 5x5
    using parts = Parts<PathWeight>;
    using reads = Channels<GuideAxis, MeanSweep, From>;
    using emits = Channels<FilteredLayer<Signal>>;
    float part;      ///< spacing of the taps, as a fraction of the sweep
    float fixed;     ///< spacing in pixels instead, where above 0
    int taps_across; ///< rows of taps to either side
    PathWeight weight;

    template <class Px> QUELL_KERNEL auto emit_channels(Px const& px) const {
        return emitted<typename Px::Real>(FilteredLayer<Signal>{}, filtered(px));
    }

    template <class Px> QUELL_KERNEL auto filtered(Px const& px) const {
        using Real = typename Px::Real;
        constexpr float spline[] = {0.375f, 0.25f, 0.0625f};
        auto const own = px[From{}];
        auto const axis = px[guide_axis];
        auto const length = sqrt(fma(axis.x, axis.x, axis.y * axis.y));
        auto const moves = length > Real(Trajectory<Real>::min_length);
        if (!any(moves)) return own;
        auto const inverse = 1.f / max(length, Real(1e-6f));
        auto const along = fixed > 0.f ? Real(fixed) : length * part;
        auto const across = fma(px[guide_spread].y, max(along - 1.f, Real(0.f)), Real(1.f));
        vec2<Real> const step{axis.x * inverse * along, axis.y * inverse * along},
            aside{-axis.y * inverse * across, axis.x * inverse * across};
        auto const p = px.position();
        auto const reach = weight.reach(px);
        auto sum = scale(own, Real(spline[0] * spline[0]));
        Real weights(spline[0] * spline[0]);
        for (int j = -taps_across; j <= taps_across; ++j)
            for (int i = -taps_along; i <= taps_along; ++i) {
                if (i == 0 && j == 0) continue;
                Real const fi(static_cast<float>(i)), fj(static_cast<float>(j));
                PixelUnder<Px> const tap(px, {fma(aside.x, fj, fma(step.x, fi, p.x)), fma(aside.y, fj, fma(step.y, fi, p.y))});
                float const w = spline[i < 0 ? -i : i] * spline[j < 0 ? -j : j];
                // A filtered value has no time of its own: take the middle.
                auto const path = Trajectory<Real>::of(px.elsewhere(tap.place, mean_sweep), Real(0.5f));
                auto const passing = path.passing({p.x - tap.column - 0.5f, p.y - tap.row - 0.5f});
                auto const counts = masked(tap.inside, weight.weight(passing, reach) * w);
                sum = add_scaled(sum, px.elsewhere(tap.place, From{}), counts);
                weights = weights + counts;
            }
        return select(moves, scale(sum, 1.f / weights), own);
    }
};
template <ChannelTag S, ChannelTag From> struct LastDirectionalLevel {
    using Signal = S;
    static constexpr auto name = "directional a-trous and composite";
    using reads = decltype(reads_of<DirectionalLevel<Signal, From>>{} | Channels<StaticLayer<Signal>>{});
    DirectionalLevel<Signal, From> level;

    template <class Px> QUELL_KERNEL auto filter(Px const& px) const {
        return layers_together(level.filtered(px), px[StaticLayer<Signal>{}], px.signal());
    }
};
} // namespace detail

/// A-trous wavelet along the motion over the moving layer (MB section 4.3), then composites the layers. Each of the `levels` passes has
/// five taps along the axis of motion, in 2 `taps_across` + 1 rows. The spacing is proportional to the sweep's length and doubles from
/// level to level. Taps are weighted by their closest approach, so that neighbouring trajectories do not mix. Needs a MotionGuide and a
/// LayerBlend before it.
/// @tparam S the pipeline's signal
template <ChannelTag S> struct DirectionalAtrous {
    using Signal = S;
    /// Its passes: the first level starts from MovingLayer, others from FilteredLayer.
    using First = detail::DirectionalLevel<Signal, MovingLayer<Signal>>;
    /// @copydoc First
    using Next = detail::DirectionalLevel<Signal, FilteredLayer<Signal>>;
    using parts = Parts<detail::LastDirectionalLevel<Signal, FilteredLayer<Signal>>, First>;
    int levels = 3;         ///< at least 2
    float reach = 0.2f;     ///< spacing of the last level's taps, as a fraction of the sweep
    float fixed_step = 0.f; ///< pixels; spacing of the first level instead of `reach`, where above 0: an ordinary a-trous filter
    int taps_across = 2;    ///< rows of taps to either side of the axis: 0 to 2
    PathWeight weight{};    ///< by the closest approach of a tap's filtered sweep

    constexpr void for_each_pass(auto&& pass) const {
        pass(level<First>(0));
        for (int i = 1; i + 1 < levels; ++i) pass(level<Next>(i));
        pass(detail::LastDirectionalLevel<Signal, FilteredLayer<Signal>>{level<Next>(levels - 1)});
    }

private:
    template <class Level> constexpr Level level(int i) const { return {step(i), fixed(i), taps_across, weight}; }
    constexpr float step(int level) const { return reach / static_cast<float>(1 << (levels - 1 - level)); }
    constexpr float fixed(int level) const { return fixed_step * static_cast<float>(1 << level); }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
