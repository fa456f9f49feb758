#pragma once

#include <baselines/moving_and_static/layers.hpp>
#include <baselines/moving_and_static/path_weight.hpp>
#include <quell/frame/cursor/taps.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Splits the picture into a moving and a static layer: the mean of each over the 5x5 neighbours, moving samples weighted by their closest
/// approach (MB section 4.3, first stage). The coverage is the share of moving samples in the MotionGuide's window. Where nothing moves, a
/// static pixel keeps its value bit by bit.
/// Emits MovingLayer, StaticLayer and MeanSweep; leaves the signal alone. Needs a MotionGuide before it.
/// @tparam S the pipeline's signal
/// @tparam Trajectories the MotionGuide's: StraightTrajectories or BentTrajectories
template <ChannelTag S, class Trajectories = StraightTrajectories> struct LayerSplit {
    using Signal = S;
    static constexpr auto name = "layer split";
    static constexpr bool leaves_signal = true;
    using parts = Parts<Trajectories, PathWeight>;
    using reads = Channels<Depth, GuideSweep>;
    using emits = Channels<MovingLayer<Signal>, StaticLayer<Signal>, MeanSweep>;
    static constexpr int radius = 2; ///< pixels: MB's 5x5
    static constexpr int farthest_tap = radius;
    PathWeight weight{};           ///< by closest approach
    float depth_tolerance = 0.02f; ///< relative difference of depth from which on a surface is behind another

    template <class Px> QUELL_KERNEL auto emit_channels(Px const& px) const {
        using Real = typename Px::Real;
        auto const own = Trajectories::here(px);
        auto const coverage = px[guide_spread].z;
        auto const alone = both(invert(own.moves()), coverage <= Real(0.f), invert(px.missing()));
        Sums<Px> sums;
        if (!all(alone)) gather(px, own, sums);
        auto const moving = sums.moving > Real(0.f), still = sums.still > Real(0.f);
        auto const inverse = 1.f / max(sums.moving, Real(1e-30f));
        auto const covers = masked(moving, coverage);
        auto const around = px[guide_sweep];
        auto const background = select(alone, px.signal(), scale(sums.behind, 1.f / max(sums.still, Real(1.f))));
        vec2<Real> const swept{select(moving, sums.sweep.x * inverse, around.x), select(moving, sums.sweep.y * inverse, around.y)};
        return emitted<Real>(MovingLayer<Signal>{}, detail::layer_of(scale(sums.front, inverse * covers), covers))
            .with(StaticLayer<Signal>{}, detail::layer_of(background, masked(either(alone, still), Real(1.f))))
            .with(mean_sweep, select(alone, zero<vec2<Real>>(), swept));
    }

private:
    template <class Px> struct Sums {
        using Real = typename Px::Real;
        typename Px::Signal front = zero<typename Px::Signal>(), behind = front;
        vec2<Real> sweep{Real(0.f), Real(0.f)};
        Real moving = Real(0.f), still = Real(0.f);
    };
    template <class Px> QUELL_KERNEL void gather(Px const& px, auto const& own, Sums<Px>& sums) const {
        using Real = typename Px::Real;
        auto const z = px[depth], reach = weight.reach(px);
        auto const nearest = select(own.moves(), Real(1e30f), z);
        for_each_neighbour<radius>(px, [&](auto neighbour, auto inside, int dx, int dy) QUELL_INLINED {
            auto const path = Trajectories::here(neighbour);
            auto const passing = path.passing({Real(static_cast<float>(-dx)), Real(static_cast<float>(-dy))});
            auto const hidden = detail::hidden_behind(neighbour[depth], nearest, depth_tolerance);
            auto const in_front = both(path.moves(), invert(hidden), invert(neighbour.missing()));
            auto const w = masked(in_front, weight.weight(passing, reach) * inside);
            auto const before = both(own.moves(), detail::hidden_behind(z, neighbour[depth], depth_tolerance));
            auto const s = masked(both(invert(path.moves()), invert(neighbour.missing()), invert(before)), inside);
            sums.front = add_scaled(sums.front, neighbour.signal(), w), sums.moving = sums.moving + w;
            sums.behind = add_scaled(sums.behind, neighbour.signal(), s), sums.still = sums.still + s;
            sums.sweep = add_scaled(sums.sweep, path.sweep, w);
        });
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
