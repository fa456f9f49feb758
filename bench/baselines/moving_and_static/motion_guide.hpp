#pragma once

#include <baselines/moving_and_static/layers.hpp>
#include <quell/blur/trajectory/trajectory.hpp>
#include <quell/filter/filter_kernel.hpp>

/// @file
/// Contract of moving_and_static/: motion blur with a moving layer of one local velocity over a static layer, as in MB.
///
///     Sweep, Time, Depth
///       |
///       v   SampleCollector (optional)     more samples for each moving pixel           (MB section 4.2)
///       v   MotionGuide                 -> GuideSweep, GuideAxis, GuideSpread, GuideBend (MB section 4.1)
///       |
///       v   LayerSplit or PathGather    -> MovingLayer, StaticLayer, MeanSweep           (MB section 4.3)
///       |
///       v   Temporal{PathSearch, LayerBlend, LayerFetch}: both layers are accumulated    (MB section 4.4)
///       |
///       v   DirectionalAtrous (optional)   smooths the moving layer along the motion     (MB section 4.3)
///     signal
namespace quell::inline QUELL_INSTRUCTION_SET {

/// Mean sweep of the moving samples around a pixel, in pixels: opposite directions cancel. 0 where nothing moves.
struct GuideSweep : InternalChannel<2> {
    static constexpr auto name = "guide_sweep";
};
/// Axis of motion around a pixel: opposite directions count as one. Its length is the mean length of the sweeps, in pixels; 0 where nothing
/// moves.
struct GuideAxis : InternalChannel<2> {
    static constexpr auto name = "guide_axis";
};
/// Spread of the sweeps around a pixel: variance of their lengths (pixels^2); circular variance of their axes (0: all equal, 1: no
/// direction prevails); and the share of samples that move.
struct GuideSpread : InternalChannel<3> {
    static constexpr auto name = "guide_spread";
};
/// Mean bend of the trajectories around a pixel, in pixels. Made only with bends.
struct GuideBend : InternalChannel<2> {
    static constexpr auto name = "guide_bend";
};
/// The channel GuideSweep.
inline constexpr GuideSweep guide_sweep;
/// The channel GuideAxis.
inline constexpr GuideAxis guide_axis;
/// The channel GuideSpread.
inline constexpr GuideSpread guide_spread;
/// The channel GuideBend.
inline constexpr GuideBend guide_bend;

namespace detail {
/// Sums over a row: `all` counts its samples, `in_motion` those that move, the rest sums over those. Bends only where
/// trajectories have them.
template <class Trajectories> struct MotionSums : InternalChannel<Trajectories::bent ? 11 : 9> {
    static constexpr auto name = "motion_sums";
    enum { all, in_motion, sweep_x, sweep_y, length, squared_length, doubled_cosine, doubled_sine, depth, bend_x, bend_y };
};
template <class Trajectories, class Real> using MotionSumsOf = Components<MotionSums<Trajectories>::components, Real>;
template <class Sums, class Mask> QUELL_KERNEL void add_where(Mask counts, Sums& sums, Sums const& more) {
    sums = map([&](auto s, auto a) QUELL_INLINED { return s + select(counts, a, decltype(a)(0.f)); }, sums, more);
}
/// Depth behind which moving samples are hidden: that of a static pixel.
template <class Trajectories, class Px> QUELL_KERNEL auto still_depth(Px const& px) {
    return select(Trajectories::here(px).moves(), typename Px::Real(1e30f), px[depth]);
}

template <class Trajectories> struct MotionRow {
    static constexpr auto name = "motion guide, rows";
    static constexpr bool leaves_signal = true;
    using parts = Parts<Trajectories>;
    using reads = Channels<Depth>;
    using emits = Channels<MotionSums<Trajectories>>;
    int radius;
    float depth_tolerance;

    constexpr int farthest_tap() const { return radius; }

    template <class Px> QUELL_KERNEL auto emit_channels(Px const& px) const {
        using Real = typename Px::Real;
        auto const nearest = still_depth<Trajectories>(px);
        auto sums = zero<MotionSumsOf<Trajectories, Real>>();
        Real samples(0.f);
        for (int i = -radius; i <= radius; ++i) {
            auto const neighbour = px.at(i, 0);
            auto const path = Trajectories::here(neighbour);
            auto const z = neighbour[depth];
            auto const known = both(neighbour.inside(), invert(neighbour.missing()));
            samples = samples + masked(known, Real(1.f));
            auto const counts = both(known, path.moves(), invert(hidden_behind(z, nearest, depth_tolerance)));
            if (!any(counts)) continue;
            auto const inverse = 1.f / max(path.squared, Real(1e-6f));
            auto const x = path.sweep.x, y = path.sweep.y;
            MotionSumsOf<Trajectories, Real> sample{Real(0.f),
                                                    Real(1.f),
                                                    x,
                                                    y,
                                                    path.length(),
                                                    path.squared,
                                                    fma(x, x, -(y * y)) * inverse,
                                                    2.f * x * y * inverse,
                                                    select(is_finite(z), min(z, Real(1e6f)), Real(1e6f))};
            if constexpr (Trajectories::bent)
                sample.at[MotionSums<Trajectories>::bend_x] = path.bend.x, sample.at[MotionSums<Trajectories>::bend_y] = path.bend.y;
            add_where(counts, sums, sample);
        }
        sums.at[MotionSums<Trajectories>::all] = samples;
        return emitted<Real>(MotionSums<Trajectories>{}, sums);
    }
};

template <class Trajectories> struct MotionColumn {
    using Sums = MotionSums<Trajectories>;
    static constexpr auto name = "motion guide, columns";
    static constexpr bool leaves_signal = true;
    using parts = Parts<Trajectories>;
    using reads = Channels<Depth, MotionSums<Trajectories>>;
    using emits = std::conditional_t<Trajectories::bent, Channels<GuideSweep, GuideAxis, GuideSpread, GuideBend>,
                                     Channels<GuideSweep, GuideAxis, GuideSpread>>;
    int radius;
    float depth_tolerance;

    constexpr int farthest_tap() const { return radius; }

    template <class Px> QUELL_KERNEL auto emit_channels(Px const& px) const {
        using Real = typename Px::Real;
        auto const nearest = still_depth<Trajectories>(px);
        auto sums = zero<MotionSumsOf<Trajectories, Real>>();
        Real samples(0.f);
        for (int i = -radius; i <= radius; ++i) {
            auto const neighbour = px.at(0, i);
            if (!neighbour.any_row_inside()) continue;
            auto row = neighbour[Sums{}];
            // Recorded, rows outside are looked at as well.
            if constexpr (records<Real>) row = select(neighbour.row_inside, row, zero<MotionSumsOf<Trajectories, Real>>());
            samples = samples + row.at[Sums::all];
            auto const mean_depth = row.at[Sums::depth] / max(row.at[Sums::in_motion], Real(1.f));
            add_where(invert(hidden_behind(mean_depth, nearest, depth_tolerance)), sums, row);
        }
        auto const some = sums.at[Sums::in_motion] > Real(0.5f);
        auto const inverse = masked(some, 1.f / max(sums.at[Sums::in_motion], Real(1.f)));
        auto const mean = scale(sums, inverse);
        auto const length = mean.at[Sums::length];
        vec3<Real> const spread{max(fma(-length, length, mean.at[Sums::squared_length]), Real(0.f)),
                                variance(mean.at[Sums::doubled_cosine], mean.at[Sums::doubled_sine], some),
                                sums.at[Sums::in_motion] / max(samples, Real(1.f))};
        auto const guide = emitted<Real>(guide_sweep, vec2<Real>{mean.at[Sums::sweep_x], mean.at[Sums::sweep_y]})
                               .with(guide_axis, axis(sums.at[Sums::doubled_cosine], sums.at[Sums::doubled_sine], length))
                               .with(guide_spread, spread);
        if constexpr (Trajectories::bent)
            return guide.with(guide_bend, vec2<Real>{mean.at[Sums::bend_x], mean.at[Sums::bend_y]});
        else
            return guide;
    }

private:
    /// The axis from a direction of doubled angle.
    template <class Real> QUELL_KERNEL static vec2<Real> axis(Real c, Real s, Real length) {
        auto const norm = sqrt(fma(c, c, s * s));
        // Where no direction prevails, any will do.
        auto const cosine = select(norm > Real(1e-6f), c / max(norm, Real(1e-6f)), Real(1.f));
        auto const x = sqrt(max(fma(cosine, Real(0.5f), Real(0.5f)), Real(0.f))),
                   y = sqrt(max(fma(cosine, Real(-0.5f), Real(0.5f)), Real(0.f)));
        return {x * length, select(s < Real(0.f), -y, y) * length};
    }
    template <class Real, class Mask> QUELL_KERNEL static Real variance(Real c, Real s, Mask some) {
        return masked(some, clamp(1.f - sqrt(fma(c, c, s * s)), Real(0.f), Real(1.f)));
    }
};
} // namespace detail

/// Mean and variance of the motion around each pixel, which say where and how far to look for samples (MB section 4.1). Static samples do
/// not count, nor do moving ones behind a static pixel. Angles are doubled before they are averaged: opposite directions count as one, and
/// neither the zero of angles nor the centre's own noisy sample matters.
/// Emits GuideSweep, GuideAxis and GuideSpread, and GuideBend with bends.
/// @tparam Trajectories StraightTrajectories or BentTrajectories
template <class Trajectories = StraightTrajectories> struct MotionGuide {
    static_assert(
        requires { typename Trajectories::reads; },
        "MotionGuide<Trajectories>: `Trajectories` is StraightTrajectories or BentTrajectories; RotatingTrajectories go with a PairGuide");
    using Row = detail::MotionRow<Trajectories>;       ///< pass over rows
    using Column = detail::MotionColumn<Trajectories>; ///< pass over columns
    static constexpr bool leaves_signal = true;
    using parts = Parts<Row, Column>;
    int radius = 7;                ///< half width of the window in pixels; 7: 15x15, as in MB
    float depth_tolerance = 0.02f; ///< relative difference of depth from which on a surface is behind another

    constexpr void for_each_pass(auto&& pass) const {
        pass(Row{radius, depth_tolerance});
        pass(Column{radius, depth_tolerance});
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
