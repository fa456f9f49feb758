#pragma once

#include <quell/blur/layers.hpp>
#include <quell/motion/motion_source.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {
/// A place in the previous frame. Its taps must have a sweep like the one here.
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

/// Motion source for blurred pictures: finds the place p' in the previous frame with p' + v(p')/2 = p - v(p)/2, where v is the motion per
/// frame (MB section 4.4). Where the two sides miss each other, p' moves by the difference and is tried again. Depth and normal are no test
/// here, as blurred pixels show several surfaces. Taps are tested by their sweeps instead.
/// @tparam SweepChannel MeanSweep or ForegroundSweep
template <ChannelTag SweepChannel> struct PathSearchOf {
    using reads = Channels<SweepChannel>;
    using keeps = Channels<SweepChannel>;
    static constexpr int farthest_tap = 0;
    int iterations = 4;   ///< further iterations (MB: 2); 0: the place is moved once, and rejected where it missed
    float accept = 0.25f; ///< pixels; the search ends at a smaller difference
    float give_up = 32.f; ///< pixels; the search fails at a larger difference
    // The place half way between two velocities satisfies the equation as well; only the sweep's length tells it apart.
    float longer = 0.07f; ///< relative tolerance of the length of a tap's sweep
    float turned = 0.5f;  ///< tolerance of its direction: about the tangent of the angle
    float alike = 0.05f;  ///< pixels; sweeps that differ by less match, however short they are

    /// The same search along another channel of sweeps.
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
            // On an arc the chord is longer than the vector mean of the velocities at its ends: by the factor 1 + angle^2 / 12.
            auto const turn_x = v.x - there.x, turn_y = v.y - there.y;
            auto const turned_by = fma(turn_x, turn_x, turn_y * turn_y) / max(fma(v.x, v.x, v.y * v.y), Real(1e-6f));
            auto const half = fma(min(turned_by, Real(1.f)), Real(-0.5f / 12.f), Real(-0.5f));
            auto const x = fma(v.x + there.x, half, p.x - found.where.x), y = fma(v.y + there.y, half, p.y - found.where.y);
            auto const squared = fma(x, x, y * y);
            found.validity = select(both(searching, squared < Real(accept * accept)), Real(1.f), found.validity);
            searching = both(searching, squared < Real(give_up * give_up));
            // Move accepted places too: half of the remaining difference would stay as blur.
            found.where =
                vec2<Real>{select(searching, found.where.x + x, found.where.x), select(searching, found.where.y + y, found.where.y)};
            searching = both(searching, found.validity <= Real(0.f));
            if (!any(searching)) break;
        }
        return found;
    }

private:
    /// Factor from a sweep to the motion per frame. With a closed shutter the result leads out of any image.
    QUELL_KERNEL static auto per_frame(auto shutter) { return 1.f / max(shutter, 1e-6f); }
};

/// Search along the mean motion, or along the background's where there are two velocities.
using PathSearch = PathSearchOf<MeanSweep>;

static_assert(MotionSource<PathSearch>);

} // namespace quell::inline QUELL_INSTRUCTION_SET
