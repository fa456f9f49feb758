#pragma once

#include <quell/motion/surface_test.hpp>

#include <algorithm>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Accepts a past pixel of a similar depth. It separates foreground from background and nothing else.
struct SimilarDepth {
    using reads = Channels<Depth>;     ///< of this frame
    using remembers = Channels<Depth>; ///< of the previous frame
    static constexpr int farthest_tap = 0;
    float tolerance = 0.2f; ///< allowed difference, as a part of this pixel's depth

    /// @cond
    template <class Real> struct Around {
        Real z, allowed;
        QUELL_KERNEL auto accepts(auto const& then, Real, Real) const { return abs(then[depth] - z) < allowed; }
    };
    QUELL_KERNEL auto around(auto px) const {
        auto const z = px[depth];
        return Around<decltype(z + z)>{z, z * tolerance};
    }
    /// @endcond
};

/// Dual motion vectors for disocclusions (TRMV eq. 6; Bowles et al. 2012). At the reprojected position the previous frame shows the
/// occluder. The source finds the occluder in this frame, and takes the pixel that had the same offset from the occluder in the previous
/// frame: similar background was visible there. Use it after a source of the surface itself: FirstValid{SurfaceMotion{}, DualMotion{}}.
/// Positions slightly outside the image move to its border; farther out, as after a cut, validity is 0.
/// @tparam Test what a past pixel must pass
template <class Test = SimilarDepth> struct DualMotion {
    using parts = Parts<Test>;                 ///< what it is made of
    using reads = Channels<Motion, Depth>;     ///< of this frame
    using remembers = Channels<Motion, Depth>; ///< of the previous frame
    static constexpr int farthest_tap = anywhere;
    Test test{};          ///< what a past pixel must pass
    float trust = 0.5f;   ///< validity of the history: similar, not the same surface
    float reach = 0.125f; ///< largest distance outside the image, as a part of its longer side

    /// See MotionSource.
    QUELL_KERNEL auto previous(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const x = px.position(), m = px[motion];
        auto const width = to_real(px.size().width), height = to_real(px.size().height);
        Real const right(width - 0.5f), bottom(height - 0.5f);
        // clamp turns NaN into the border.
        vec2<Real> const y{clamp(x.x + m.x, Real(0.5f), right), clamp(x.y + m.y, Real(0.5f), bottom)};
        auto const beyond_x = abs(y.x - (x.x + m.x)), beyond_y = abs(y.y - (x.y + m.y));
        auto const outside = either(beyond_x > Real(0.f), beyond_y > Real(0.f));
        Real const allowed(reach * max(width, height));
        auto const within = both(is_finite(m.x), is_finite(m.y), beyond_x < allowed, beyond_y < allowed);
        auto const z = carried_forward(px, y);
        vec2<Real> const where{select(outside, y.x, y.x + (x.x - z.x)), select(outside, y.y, y.y + (x.y - z.y))};
        return TestedReprojection<Real, decltype(test.around(px))>{where, masked(within, Real(trust)), test.around(px)};
    }

private:
    /// The position in this frame of what the previous frame showed at y. Hosts supply motion backwards only. The first guess assumes that
    /// the previous motion continues. Two fixed-point steps correct it: motion at the result must lead back to y.
    template <class Px, class Real> QUELL_KERNEL static vec2<Real> carried_forward(Px const& px, vec2<Real> const& y) {
        auto const place = nearest_place(px, y);
        auto const occluder = px.past(place);
        auto const before = occluder[motion];
        auto const z_then = occluder[depth];
        auto const steady = both(is_finite(before.x), is_finite(before.y));
        vec2<Real> z{select(steady, y.x - before.x, y.x), select(steady, y.y - before.y, y.y)};
        for (int i = 0; i < 2; ++i) {
            auto const there = nearest_place(px, z);
            auto const its_motion = px.elsewhere(there, motion);
            auto const same = abs(px.elsewhere(there, depth) - z_then) < z_then * 0.1f;
            auto const found = both(same, is_finite(its_motion.x), is_finite(its_motion.y));
            z = vec2<Real>{select(found, y.x - its_motion.x, z.x), select(found, y.y - its_motion.y, z.y)};
        }
        return z;
    }
};
template <class Test> DualMotion(Test) -> DualMotion<Test>;

} // namespace quell::inline QUELL_INSTRUCTION_SET
