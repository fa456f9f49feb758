#pragma once

#include <quell/blur/layers.hpp>
#include <quell/motion/motion_source.hpp>

namespace quell {

namespace detail {
/// A place in the past, and the sweep that its taps must have.
template <class SweepChannel, class Real> struct PathFound {
    vec2<Real> where;
    Real validity;
    decltype(Real(0.f) < Real(0.f)) still;
    vec2<Real> sweep;
    Real length, length_tolerance, turn_squared;
    QUELL_KERNEL auto accepts(auto const& then, Real, Real) const {
        auto const there = then[SweepChannel{}];
        auto const x = there.x - sweep.x, y = there.y - sweep.y;
        return both(abs(sqrt(fma(there.x, there.x, there.y * there.y)) - length) <= length_tolerance, fma(x, x, y * y) <= turn_squared);
    }
};
} // namespace detail

/// Finds the past of what moves over a pixel by looking from both sides: going back half a frame from here and forward half a frame from
/// the place in the past should meet (MB section 4.4). Where they miss, the place is moved by the difference and tried again. No depth or
/// normal serves as a test, as no two frames show the same in pixels that are blurred.
/// @tparam SweepChannel MeanSweep, or FrontSweep
template <ChannelTag SweepChannel> struct PathSearchOf {
    using reads = Channels<SweepChannel>;
    using keeps = Channels<SweepChannel>;
    int iterations = 4;   ///< how often the place may be moved again (MB: 2); 0: it is moved once, and refused where it missed
    float accept = 0.25f; ///< pixels; a difference below it will do
    float give_up = 32.f; ///< pixels; a difference beyond it will not be mended
    // The place half way between two motions satisfies both directions as well: what differs in length is another thing.
    float longer = 0.07f; ///< how much longer or shorter, relatively, a past pixel's sweep may be
    float turned = 0.5f;  ///< how far it may have turned: the tangent of the angle, about
    float alike = 0.05f;  ///< pixels; sweeps that differ less are one, however short

    /// The same search along another channel.
    template <ChannelTag Other> constexpr PathSearchOf<Other> along(Other) const {
        return {.iterations = iterations, .accept = accept, .give_up = give_up, .longer = longer, .turned = turned, .alike = alike};
    }
    template <class Px> QUELL_KERNEL auto previous(Px const& px) const {
        using Real = typename Px::Real;
        auto const own = px[SweepChannel{}];
        auto const p = px.position(), v = scale(own, Real(per_frame(px.shutter_now())));
        auto const moves = fma(v.x, v.x, v.y * v.y) > Real(0.01f);
        auto const length = sqrt(fma(own.x, own.x, own.y * own.y)), slack = Real(alike);
        auto const turn = max(slack, length * turned);
        detail::PathFound<SweepChannel, Real> found{{p.x - v.x, p.y - v.y},
                                                    select(moves, Real(0.f), Real(1.f)),
                                                    invert(moves),
                                                    own,
                                                    length,
                                                    max(slack, length * longer),
                                                    turn * turn};
        if (!any(moves)) return found;
        Real const per_frame_then(per_frame(px.shutter_then()));
        auto searching = moves;
        for (int i = 0; i <= iterations; ++i) {
            auto const place = nearest_place(px, found.where);
            auto const there = scale(px.past(place)[SweepChannel{}], per_frame_then);
            // On an arc the way back is a little longer than the mean of the speeds at its ends: by a twelfth of the turn, squared.
            auto const turn_x = v.x - there.x, turn_y = v.y - there.y;
            auto const turned_by = fma(turn_x, turn_x, turn_y * turn_y) / max(fma(v.x, v.x, v.y * v.y), Real(1e-6f));
            auto const half = fma(min(turned_by, Real(1.f)), Real(-0.5f / 12.f), Real(-0.5f));
            auto const x = fma(v.x + there.x, half, p.x - found.where.x), y = fma(v.y + there.y, half, p.y - found.where.y);
            auto const squared = fma(x, x, y * y);
            found.validity = select(both(searching, squared < Real(accept * accept)), Real(1.f), found.validity);
            searching = both(searching, squared < Real(give_up * give_up));
            // Also what is near enough already: it costs nothing, and half the difference would stay as a blur.
            found.where =
                vec2<Real>{select(searching, found.where.x + x, found.where.x), select(searching, found.where.y + y, found.where.y)};
            searching = both(searching, found.validity <= Real(0.f));
            if (!any(searching)) break;
        }
        return found;
    }

private:
    /// What makes the way between frames of a sweep. Where there was no time to sweep in, it leads out of any image.
    QUELL_KERNEL static float per_frame(float shutter) { return 1.f / max(shutter, 1e-6f); }
};

/// Along the mean motion of the picture, or of the background where two layers meet.
using PathSearch = PathSearchOf<MeanSweep>;

static_assert(MotionSource<PathSearch>);

} // namespace quell
