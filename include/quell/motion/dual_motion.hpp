#pragma once

#include <quell/motion/surface_test.hpp>

#include <algorithm>

namespace quell {

/// A depth not far from this pixel's: keeps what is near apart from what is behind it, and nothing else.
struct SimilarDepth {
    using reads = Channels<Depth>;
    using remembers = Channels<Depth>;
    float tolerance = 0.2f; ///< as a part of the depth

    template <class Real> struct Around {
        Real z, allowed;
        QUELL_KERNEL auto accepts(auto const& then, Real, Real) const { return abs(then[depth] - z) < allowed; }
    };
    QUELL_KERNEL auto around(auto px) const {
        auto const z = px[depth];
        return Around<decltype(z + z)>{z, z * tolerance};
    }
};

/// For what has just been uncovered (TRMV eq. 6; Bowles 2012): where this surface would have been, the previous frame shows the occluder.
/// As far as this pixel is now from the occluder, as far from it then there is a place whose surroundings look alike. Use it behind a
/// source of the surface itself: FirstValid{SurfaceMotion{}, DualMotion{}}. History that would come from not far outside the image is taken
/// from its border; what was farther away, as after a cut, has none.
/// @tparam Test what a past pixel must pass
template <class Test = SimilarDepth> struct DualMotion {
    using parts = Parts<Test>;
    using reads = Channels<Motion, Depth>;
    using remembers = Channels<Motion, Depth>;
    Test test{};
    float trust = 0.5f;   ///< validity of what is found: it is alike, but not the same
    float reach = 0.125f; ///< how far outside the image the border still stands for, as a part of the image's longer side

    QUELL_KERNEL auto previous(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const x = px.position(), m = px[motion];
        Real const right(static_cast<float>(px.size().width) - 0.5f), bottom(static_cast<float>(px.size().height) - 0.5f);
        // What is not finite becomes the border by clamp.
        vec2<Real> const y{clamp(x.x + m.x, Real(0.5f), right), clamp(x.y + m.y, Real(0.5f), bottom)};
        auto const beyond_x = abs(y.x - (x.x + m.x)), beyond_y = abs(y.y - (x.y + m.y));
        auto const outside = either(beyond_x > Real(0.f), beyond_y > Real(0.f));
        Real const allowed(reach * static_cast<float>(std::max(px.size().width, px.size().height)));
        auto const within = both(is_finite(m.x), is_finite(m.y), beyond_x < allowed, beyond_y < allowed);
        auto const z = carried_forward(px, y);
        vec2<Real> const where{select(outside, y.x, y.x + (x.x - z.x)), select(outside, y.y, y.y + (x.y - z.y))};
        return detail::TestedReprojection<Real, decltype(test.around(px))>{where, masked(within, Real(trust)), test.around(px)};
    }

private:
    /// Where what the previous frame showed at y is now. Hosts supply motion backwards only; so the answer is guessed from the motion
    /// before, and corrected by what is there now: its own motion must lead back to y.
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

} // namespace quell
