#pragma once

#include <quell/frame/pixel.hpp>

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
        vec2<Real> v{clamp(select(usable, sweep.x, Real(0.f)), Real(-longest), Real(longest)),
                     clamp(select(usable, sweep.y, Real(0.f)), Real(-longest), Real(longest))};
        return {v, clamp(select(is_finite(time), time, Real(0.5f)), Real(0.f), Real(1.f)), fma(v.x, v.x, v.y * v.y)};
    }
    QUELL_KERNEL auto moves() const { return squared > Real(least * least); }
    QUELL_KERNEL Real length() const { return sqrt(squared); }

    /// How far from a point it passes, in pixels, and when (MB eq. 1). `offset` is the point minus the sample's pixel.
    struct Passing {
        Real distance, when;
        /// Whether that is while the shutter is open.
        QUELL_KERNEL auto in_time() const { return both(when >= Real(0.f), when <= Real(1.f)); }
    };
    QUELL_KERNEL Passing passing(vec2<Real> const& offset) const {
        auto const along = fma(offset.x, sweep.x, offset.y * sweep.y) / max(squared, Real(1e-12f));
        auto const x = fma(-along, sweep.x, offset.x), y = fma(-along, sweep.y, offset.y);
        return {sqrt(fma(x, x, y * y)), time + along};
    }
};

} // namespace quell
