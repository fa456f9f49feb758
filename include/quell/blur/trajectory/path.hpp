#pragma once

#include <quell/frame/cursor/pixel.hpp>

namespace quell {

/// How what a pixel shows moves while the shutter is open: in a straight line, at even speed, through the pixel's centre at the sample's
/// time. Bad input has a meaning: a sweep that is not finite is none, a longer one than `longest` is as long as that, a time that is not
/// finite is the middle, and one outside [0, 1] the nearer end.
template <class Real> struct Path {
    static constexpr float least = 0.5f;     ///< pixels; what sweeps less stands still
    static constexpr float longest = 1024.f; ///< pixels

    vec2<Real> sweep; ///< from where it is when the shutter opens to where it is when it closes, in pixels
    Real time;        ///< of the sample, in [0, 1]
    Real squared;     ///< the sweep's length, squared

    /// From the channels Sweep and Time.
    QUELL_KERNEL static Path of(vec2<Real> const& sweep, Real time) {
        auto const usable = both(is_finite(sweep.x), is_finite(sweep.y));
        vec2<Real> v{clamp(masked(usable, sweep.x), Real(-longest), Real(longest)),
                     clamp(masked(usable, sweep.y), Real(-longest), Real(longest))};
        return {v, clamp(select(is_finite(time), time, Real(0.5f)), Real(0.f), Real(1.f)), fma(v.x, v.x, v.y * v.y)};
    }
    QUELL_KERNEL auto moves() const { return squared > Real(least * least); }
    QUELL_KERNEL Real length() const { return sqrt(squared); }
    QUELL_KERNEL Real per_squared() const { return 1.f / max(squared, Real(1e-12f)); }
    /// The time that it takes to pass a pixel, as a part of the open shutter.
    QUELL_KERNEL Real time_per_pixel() const { return min(sqrt(per_squared()), Real(1.f / least)); }

    /// How far from a point it passes, in pixels, and when (MB eq. 1). `offset` is the point minus the sample's pixel.
    struct Passing {
        Real distance, when;
        /// Whether that is while the shutter is open.
        QUELL_KERNEL auto in_time() const { return both(when >= Real(0.f), when <= Real(1.f)); }
    };
    QUELL_KERNEL Passing passing(vec2<Real> const& offset) const {
        auto const along = fma(offset.x, sweep.x, offset.y * sweep.y) * per_squared();
        auto const x = fma(-along, sweep.x, offset.x), y = fma(-along, sweep.y, offset.y);
        return {sqrt(fma(x, x, y * y)), time + along};
    }
};

/// A path that bends: to second order, sample(t) = where it is when the shutter opens + sweep t + 4 bend t (1 - t).
template <class Real> struct BentPath : Path<Real> {
    vec2<Real> bend; ///< how far from the middle of the sweep it is at half time, in pixels; one that is not finite is none

    QUELL_KERNEL static BentPath of(Path<Real> const& path, vec2<Real> const& bend) {
        constexpr auto most = Path<Real>::longest;
        auto const usable = both(is_finite(bend.x), is_finite(bend.y));
        return {path, {clamp(masked(usable, bend.x), Real(-most), Real(most)), clamp(masked(usable, bend.y), Real(-most), Real(most))}};
    }
    /// By Newton's method from where the straight path passes.
    QUELL_KERNEL typename Path<Real>::Passing passing(vec2<Real> const& offset) const {
        auto const& v = this->sweep;
        auto const t = this->time, begin = fma(-t, t, t) * 4.f;
        auto when = clamp(Path<Real>::passing(offset).when, Real(-0.5f), Real(1.5f));
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

/// Where the mask holds, a; elsewhere b's motion with a's time.
template <class Mask, class Real> QUELL_KERNEL Path<Real> moving_as(Mask mask, Path<Real> const& a, Path<Real> const& b) {
    return {select(mask, a.sweep, b.sweep), a.time, select(mask, a.squared, b.squared)};
}
template <class Mask, class Real> QUELL_KERNEL BentPath<Real> moving_as(Mask mask, BentPath<Real> const& a, BentPath<Real> const& b) {
    return {moving_as(mask, static_cast<Path<Real> const&>(a), static_cast<Path<Real> const&>(b)), select(mask, a.bend, b.bend)};
}

// How samples move while the shutter is open: in straight lines, as in the paper, or in arcs (TurningPaths: turn_guide.hpp).

/// Straight paths, of what a channel says.
/// @tparam SweepChannel Sweep; or the SweepOf a signal that does not move like the surface which shows it
template <ChannelTag SweepChannel> struct StraightPathsAlong {
    static constexpr bool bent = false;
    using reads = Channels<SweepChannel, Time>;
    /// What the pixel shows, and what is shown elsewhere.
    template <class Px> QUELL_KERNEL static auto here(Px const& px) { return Path<typename Px::Real>::of(px[SweepChannel{}], px[time]); }
    template <class Px, class Place> QUELL_KERNEL static auto there(Px const& px, Place const& place) {
        return Path<typename Px::Real>::of(px.elsewhere(place, SweepChannel{}), px.elsewhere(place, time));
    }
};
using StraightPaths = StraightPathsAlong<Sweep>;
/// Arcs, of what the host says that the surface does.
struct BentPaths {
    static constexpr bool bent = true;
    using reads = Channels<Sweep, SweepBend, Time>;
    template <class Px> QUELL_KERNEL static auto here(Px const& px) {
        return BentPath<typename Px::Real>::of(StraightPaths::here(px), px[sweep_bend]);
    }
    template <class Px, class Place> QUELL_KERNEL static auto there(Px const& px, Place const& place) {
        return BentPath<typename Px::Real>::of(StraightPaths::there(px, place), px.elsewhere(place, sweep_bend));
    }
};

} // namespace quell
