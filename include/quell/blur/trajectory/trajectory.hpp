#pragma once

#include <quell/frame/cursor/pixel.hpp>

/// @file
/// Contract of blur/trajectory/: how the surface that a sample shows moves on the screen while the shutter is open. A `Trajectories` type
/// chooses the model and the channels that it reads; guides turn these into one channel that is safe to use.
///
///     Sweep, Time  -> StraightTrajectories -+
///     Sweep, SweepBend, Time         |
///                  -> BentTrajectories -----+-> PathGuide<Trajectories> -> SampleTrajectory<Trajectories> -> two_motions/
///     Sweep, Time, Depth             |
///                  -> RotatingTrajectories --+   (PathGuide<RotatingTrajectories> is RotationGuide: SampleTrajectory<StraightTrajectories>
///                                         -> RotationSums -> SampleTrajectory<RotatingTrajectories>)
namespace quell::inline QUELL_INSTRUCTION_SET {

/// Linear trajectory of a sample: constant velocity through the pixel's centre at the sample's time. Bad input is repaired: a sweep that is
/// not finite becomes 0, its components are clamped to +-`longest`, a time that is not finite becomes 0.5, others are clamped to [0, 1].
template <class Real> struct Trajectory {
    static constexpr float min_length = 0.5f; ///< pixels; a shorter sweep counts as static
    static constexpr float longest = 1024.f;  ///< pixels; of each component

    vec2<Real> sweep; ///< displacement from shutter opening to closing, in pixels
    Real time;        ///< time of the sample: 0 shutter opening, 1 closing
    Real squared;     ///< squared length of the sweep

    /// From values of the channels Sweep and Time.
    QUELL_KERNEL static Trajectory of(vec2<Real> const& displacement, Real when) {
        auto const usable = both(is_finite(displacement.x), is_finite(displacement.y));
        vec2<Real> v{clamp(masked(usable, displacement.x), Real(-longest), Real(longest)),
                     clamp(masked(usable, displacement.y), Real(-longest), Real(longest))};
        return {v, clamp(select(is_finite(when), when, Real(0.5f)), Real(0.f), Real(1.f)), fma(v.x, v.x, v.y * v.y)};
    }
    QUELL_KERNEL auto moves() const { return squared > Real(min_length * min_length); } ///< not static
    QUELL_KERNEL Real length() const { return sqrt(squared); }                          ///< of the sweep, in pixels
    QUELL_KERNEL Real per_squared() const { return 1.f / max(squared, Real(1e-12f)); }  ///< 1 / squared length, finite for a static sample
    /// Time to cross one pixel, as a fraction of the open shutter; at most 1 / `min_length`.
    QUELL_KERNEL Real time_per_pixel() const { return min(sqrt(per_squared()), Real(1.f / min_length)); }

    /// Closest approach to a point (MB eq. 1).
    struct ClosestApproach {
        /// Distance in pixels, and its time: [0, 1] while the shutter is open.
        Real distance, when;
        /// Whether the shutter is open then.
        QUELL_KERNEL auto in_time() const { return both(when >= Real(0.f), when <= Real(1.f)); }
    };
    /// @param offset the point minus the sample's pixel, in pixels. Of a static sample the result means nothing.
    QUELL_KERNEL ClosestApproach passing(vec2<Real> const& offset) const {
        auto const along = fma(offset.x, sweep.x, offset.y * sweep.y) * per_squared();
        auto const x = fma(-along, sweep.x, offset.x), y = fma(-along, sweep.y, offset.y);
        return {sqrt(fma(x, x, y * y)), time + along};
    }
};

/// Trajectory of second order: position(t) = position(0) + sweep t + 4 bend t (1 - t).
template <class Real> struct BentTrajectory : Trajectory<Real> {
    vec2<Real> bend; ///< distance from the middle of the sweep to the position at t = 0.5, in pixels; repaired like the sweep

    /// Adds a bend, a value of the channel SweepBend.
    QUELL_KERNEL static BentTrajectory of(Trajectory<Real> const& path, vec2<Real> const& bend) {
        constexpr auto limit = Trajectory<Real>::longest;
        auto const usable = both(is_finite(bend.x), is_finite(bend.y));
        return {path, {clamp(masked(usable, bend.x), Real(-limit), Real(limit)), clamp(masked(usable, bend.y), Real(-limit), Real(limit))}};
    }
    /// Closest approach by two steps of Newton's method from the linear trajectory's.
    QUELL_KERNEL typename Trajectory<Real>::ClosestApproach passing(vec2<Real> const& offset) const {
        auto const& v = this->sweep;
        auto const t = this->time, begin = fma(-t, t, t) * 4.f;
        auto when = clamp(Trajectory<Real>::passing(offset).when, Real(-0.5f), Real(1.5f));
        vec2<Real> off{Real(0.f), Real(0.f)};
        for (int i = 0; i < 3; ++i) {
            auto const bent = fma(-when, when, when) * 4.f - begin, since = when - t;
            off = {fma(-bend.x, bent, fma(-v.x, since, offset.x)), fma(-bend.y, bent, fma(-v.y, since, offset.y))};
            if (i == 2) break;
            auto const turned = fma(when, Real(-8.f), Real(4.f));
            vec2<Real> const speed{fma(bend.x, turned, v.x), fma(bend.y, turned, v.y)};
            auto const squared_speed = max(fma(speed.x, speed.x, speed.y * speed.y), Real(1e-6f));
            when = clamp(when + fma(off.x, speed.x, off.y * speed.y) / squared_speed, Real(-0.5f), Real(1.5f));
        }
        return {sqrt(fma(off.x, off.x, off.y * off.y)), when};
    }
};

/// Linear trajectories from a channel of sweeps, as in MB.
/// @tparam SweepChannel Sweep; or SweepOf a signal that moves unlike the surface that shows it, such as a shadow
template <ChannelTag SweepChannel> struct StraightTrajectoriesAlong {
    /// Whether trajectories have a bend.
    static constexpr bool bent = false;
    using reads = Channels<SweepChannel, Time>;
    static constexpr int farthest_tap = 0;
    /// Trajectory of this pixel's sample.
    template <class Px> QUELL_KERNEL static auto here(Px const& px) {
        return Trajectory<typename Px::Real>::of(px[SweepChannel{}], px[time]);
    }
    /// Trajectory of another pixel's sample.
    template <class Px, class Place> QUELL_KERNEL static auto there(Px const& px, Place const& place) {
        return Trajectory<typename Px::Real>::of(px.elsewhere(place, SweepChannel{}), px.elsewhere(place, time));
    }
};
/// Linear trajectories from Sweep.
using StraightTrajectories = StraightTrajectoriesAlong<Sweep>;
/// Trajectories of second order, with bends from the host.
struct BentTrajectories {
    static constexpr bool bent = true; ///< trajectories have a bend
    using reads = Channels<Sweep, SweepBend, Time>;
    static constexpr int farthest_tap = 0;
    /// Trajectory of this pixel's sample.
    template <class Px> QUELL_KERNEL static auto here(Px const& px) {
        return BentTrajectory<typename Px::Real>::of(StraightTrajectories::here(px), px[sweep_bend]);
    }
    /// Trajectory of another pixel's sample.
    template <class Px, class Place> QUELL_KERNEL static auto there(Px const& px, Place const& place) {
        return BentTrajectory<typename Px::Real>::of(StraightTrajectories::there(px, place), px.elsewhere(place, sweep_bend));
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
