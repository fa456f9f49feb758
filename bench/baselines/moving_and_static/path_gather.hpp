#pragma once

#include <baselines/moving_and_static/path_weight.hpp>
#include <baselines/pixel_under.hpp>
#include <quell/blur/inpainted_layer.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Where the mask holds, a; elsewhere a's time with b's motion.
template <class Mask, class Real> QUELL_KERNEL Trajectory<Real> moving_as(Mask mask, Trajectory<Real> const& a, Trajectory<Real> const& b) {
    return {select(mask, a.sweep, b.sweep), a.time, select(mask, a.squared, b.squared)};
}
/// The same for trajectories of second order.
template <class Mask, class Real>
QUELL_KERNEL BentTrajectory<Real> moving_as(Mask mask, BentTrajectory<Real> const& a, BentTrajectory<Real> const& b) {
    return {moving_as(mask, static_cast<Trajectory<Real> const&>(a), static_cast<Trajectory<Real> const&>(b)),
            select(mask, a.bend, b.bend)};
}

/// Places to look for samples that may pass a pixel: stratified along the mean trajectory, over its whole length to both sides.
/// @tparam Trajectories StraightTrajectories or BentTrajectories
template <class Trajectories = StraightTrajectories> struct AlongGuide {
    using reads = std::conditional_t<Trajectories::bent, Channels<GuideAxis, GuideBend>, Channels<GuideAxis>>;
    int count = 24;     ///< number of places, at least 1
    float across = 1.f; ///< largest distance from the line, in pixels, to either side

    /// The places of one pixel.
    template <class Px> struct Places {
        /// float, or a pack of floats.
        using Real = typename Px::Real;
        /// Pixel coordinates; the axis, its unit normal and the mean bend, in pixels.
        vec2<Real> centre, axis, beside, bend;
        Real first, second; ///< random in [0, 1)
        /// 1 / count, and AlongGuide::across.
        float spacing, across;

        // fma fixes the rounding, which decides which pixel is visited.
        /// Pixel coordinates of place i.
        QUELL_KERNEL vec2<Real> at(int i) const {
            auto const number = Real(static_cast<float>(i));
            auto const stratum = fraction(fma(number, Real(0.618034f), first)) + number;
            auto const along = fma(stratum, Real(2.f * spacing), Real(-1.f));
            auto const aside = fma(fraction(fma(number, Real(0.7548777f), second)), Real(2.f * across), Real(-across));
            vec2<Real> const on_line{fma(beside.x, aside, fma(axis.x, along, centre.x)),
                                     fma(beside.y, aside, fma(axis.y, along, centre.y))};
            if constexpr (!Trajectories::bent) return on_line;
            // To second order, a trajectory through this pixel, at whichever time it was sampled.
            auto const bent = along * along * -4.f;
            return {fma(bend.x, bent, on_line.x), fma(bend.y, bent, on_line.y)};
        }
        /// Fractional part.
        QUELL_KERNEL static Real fraction(Real a) { return a - floor(a); }
    };
    /// The places of a pixel, from its random numbers.
    template <class Px> QUELL_KERNEL Places<Px> places(Px const& px) const {
        using Real = typename Px::Real;
        auto const axis = px[guide_axis];
        auto const inverse = 1.f / max(sqrt(fma(axis.x, axis.x, axis.y * axis.y)), Real(1e-6f));
        auto const [first, second] = px.random_uniforms();
        return {px.position(), axis,   {-axis.y * inverse, axis.x * inverse}, bend(px),
                first,         second, 1.f / static_cast<float>(count),       across};
    }

private:
    template <class Px> QUELL_KERNEL static vec2<typename Px::Real> bend([[maybe_unused]] Px const& px) {
        if constexpr (Trajectories::bent)
            return px[guide_bend];
        else
            return zero<vec2<typename Px::Real>>();
    }
};

/// Gathers samples that pass each pixel while the shutter is open into two layers: the mean of the moving samples with their coverage, and
/// the static one (after MB sections 4.2 and 4.3). A sample is weighted by the time it takes to cross a pixel, as a faster surface is seen
/// in more pixels. A static pixel keeps its value bit by bit; where it is covered, the static layer is guessed from neighbours.
/// Emits MovingLayer, StaticLayer and MeanSweep; leaves the signal alone. Needs a MotionGuide before it.
/// @tparam S the pipeline's signal
/// @tparam Trajectories the MotionGuide's: StraightTrajectories or BentTrajectories
/// @tparam Places where to look
template <ChannelTag S, class Trajectories = StraightTrajectories, class Places = AlongGuide<Trajectories>> struct PathGather {
    using Signal = S;
    static constexpr auto name = "path gather";
    static constexpr bool leaves_signal = true;
    using parts = Parts<Trajectories, Places, PathWeight>;
    using reads = Channels<Depth, GuideSweep, GuideAxis>;
    using emits = Channels<MovingLayer<Signal>, StaticLayer<Signal>, MeanSweep>;
    Places where{};                ///< where to look
    PathWeight weight{};           ///< by closest approach
    float depth_tolerance = 0.02f; ///< relative difference of depth from which on a surface is behind another

    template <class Px> QUELL_KERNEL auto emit_channels(Px const& px) const {
        using Real = typename Px::Real;
        auto const own = Trajectories::here(px);
        auto const around = px[guide_sweep];
        auto const z = px[depth];
        auto const signal = px.signal();
        auto const seen = invert(px.missing());
        auto const guide = guide_path(px);
        Gathered<Px> sums(guide.length());
        if (any(px[guide_spread].z > Real(0.f))) {
            auto const reach = weight.reach(px);
            auto const share = select(own.moves(), guide.length() / max(own.length(), Real(Trajectory<Real>::min_length)), Real(1.f));
            sums.add(signal, own, masked(seen, share), own.moves(), own.time);
            auto const places = where.places(px);
            for (int i = 0; i < where.count; ++i) add_sample(px, sums, places.at(i), own, guide, z, reach);
        }
        auto const found = sums.swept > Real(0.f);
        auto const inverse = 1.f / max(sums.swept, Real(1e-6f));
        vec2<Real> const swept{select(found, sums.sweep.x * inverse, around.x), select(found, sums.sweep.y * inverse, around.y)};
        auto const still_here = both(seen, invert(own.moves()));
        auto still = detail::layer_of(select(still_here, signal, zero<typename Px::Signal>()), masked(still_here, Real(1.f)));
        if (any(invert(still_here))) still = select(still_here, still, guessed(px, z, own.moves()));
        return emitted<Real>(MovingLayer<Signal>{}, sums.mean()).with(StaticLayer<Signal>{}, still).with(mean_sweep, swept);
    }

private:
    /// Mean trajectory around the pixel.
    template <class Px> QUELL_KERNEL static auto guide_path(Px const& px) {
        using Real = typename Px::Real;
        auto const straight = Trajectory<Real>::of(px[guide_axis], Real(0.5f));
        if constexpr (Trajectories::bent)
            return BentTrajectory<Real>::of(straight, px[guide_bend]);
        else
            return straight;
    }
    /// Stratified sums over the open shutter: the mean of the strata's means has less noise than the mean of all samples.
    template <class Px> struct Gathered {
        using Real = typename Px::Real;
        static constexpr int most_strata = 8; ///< each is at least as long as it takes to cross `pixels_a_stratum`
        static constexpr float pixels_a_stratum = 4.f;
        /// Sums of one stratum.
        struct Stratum {
            typename Px::Signal signal = zero<typename Px::Signal>(); ///< of moving samples
            Real weight = Real(0.f), all = Real(0.f);                 ///< sums of weights of the moving samples, and of all
        };
        Real count; ///< number of strata, from 1
        Stratum strata[most_strata];
        vec2<Real> sweep{Real(0.f), Real(0.f)};
        Real swept = Real(0.f);

        QUELL_KERNEL explicit Gathered(Real length)
            : count(floor(clamp(length * (1.f / pixels_a_stratum), Real(1.f), Real(static_cast<float>(most_strata))))) {}
        QUELL_KERNEL void add(typename Px::Signal const& value, auto const& path, Real w, auto moves, Real when) {
            auto const counted = masked(moves, w);
            sweep = add_scaled(sweep, path.sweep, counted);
            swept = swept + counted;
            // The last stratum includes its end.
            auto const which = min(floor(when * count), count - 1.f);
            for (int i = 0; i < most_strata; ++i) {
                auto const here = abs(which - static_cast<float>(i)) < Real(0.5f);
                auto const all_here = masked(here, w), counted_here = masked(here, counted);
                strata[i].all = strata[i].all + all_here;
                strata[i].weight = strata[i].weight + counted_here;
                strata[i].signal = add_scaled(strata[i].signal, value, counted_here);
            }
        }
        QUELL_KERNEL auto mean() const {
            auto sum = zero<Value<Signal::components + 1, Real>>();
            Real known(0.f);
            for (auto const& p : strata) {
                auto const some = p.all > Real(0.f);
                auto const inverse = masked(some, 1.f / max(p.all, Real(1e-6f)));
                sum = add_scaled(sum, detail::layer_of(p.signal, p.weight), inverse);
                known = known + masked(some, Real(1.f));
            }
            return scale(sum, 1.f / max(known, Real(1.f)));
        }
    };
    /// A static sample is tested as if it moved like its surroundings: the number of samples must not depend on what they show.
    template <class Px, class Real, class PathOf>
    QUELL_KERNEL void add_sample(Px const& px, Gathered<Px>& sums, vec2<Real> const& at, PathOf const& own, PathOf const& guide,
                                 Real own_depth, Real reach) const {
        PixelUnder<Px> const there(px, at);
        auto const path = Trajectories::there(px, there.place);
        auto const [value, missing] = px.signal_elsewhere(there.place);
        auto const hidden = both(invert(own.moves()), detail::hidden_behind(px.elsewhere(there.place, depth), own_depth, depth_tolerance));
        auto const moves = both(path.moves(), invert(hidden));
        auto const looked_at = moving_as(path.moves(), path, guide);
        auto const centre = px.position();
        auto const passing = looked_at.passing({centre.x - there.column - 0.5f, centre.y - there.row - 0.5f});
        auto const usable = both(invert(missing), there.inside);
        auto const w = weight.weight(passing, reach) / max(looked_at.length(), Real(Trajectory<Real>::min_length));
        sums.add(value, path, masked(usable, w * guide.length()), moves, passing.when);
    }
    /// The static layer behind a moving pixel.
    template <class Px, class Real, class Mask> QUELL_KERNEL auto guessed(Px const& px, Real own_depth, Mask own_moves) const {
        constexpr float guess = 0.05f;
        return detail::inpainted_layer(px, guess, [&](auto const& neighbour) QUELL_INLINED {
            auto const before = both(own_moves, detail::hidden_behind(own_depth, neighbour[depth], depth_tolerance));
            return both(invert(Trajectories::here(neighbour).moves()), invert(neighbour.missing()), invert(before));
        });
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
