#pragma once

#include <quell/frame/cursor/depth_slope.hpp>
#include <quell/motion/motion_source.hpp>

namespace quell {

// Tests of whether a past pixel shows the surface that this pixel shows. `around(px)` prepares what does not depend on the tap;
// `accepts(then, dx, dy)` then judges one tap, dx and dy pixels away from the reprojected position. A test may have `around(px,
// depth_then)` too, for sources that know the surface's depth in the previous frame.

namespace detail {
template <class Test> QUELL_KERNEL auto around(Test const& test, auto px, auto depth_then) {
    if constexpr (requires { test.around(px, depth_then); })
        return test.around(px, depth_then);
    else
        return test.around(px);
}
/// A place in the past together with the test that its taps must pass.
template <class Real, class Prepared> struct TestedReprojection {
    vec2<Real> where;
    Real validity;
    Prepared test;
    QUELL_KERNEL auto accepts(auto const& then, Real dx, Real dy) const { return test.accepts(then, dx, dy); }
};
/// Whether a vector is anything like a unit vector.
template <class Real> QUELL_KERNEL auto is_direction(vec3<Real> const& n) { return both(all_finite(n), dot(n, n) > Real(0.25f)); }
} // namespace detail

/// The depth that the surface's plane has there. A miss accepts only misses.
struct SameDepth {
    using reads = Channels<Depth>;
    using remembers = Channels<Depth>;
    /// Allowed distance from the plane, as a part of the depth. Sources that don't know the depth in the previous frame take it for this
    /// frame's: then it is also how much depth may change in a frame.
    float tolerance = 0.05f;

    template <class Real> struct Plane {
        Real z, slope_x, slope_y, allowed;
        QUELL_KERNEL auto accepts(auto const& then, Real dx, Real dy) const {
            auto const z_then = then[depth];
            auto const on_plane = abs(z_then - (z + slope_x * dx + slope_y * dy)) < allowed;
            auto const hit = is_finite(z), hit_then = is_finite(z_then);
            return either(both(hit, hit_then, on_plane), invert(either(hit, hit_then)));
        }
    };
    QUELL_KERNEL auto around(auto px) const { return around(px, px[depth]); }
    QUELL_KERNEL auto around(auto px, auto z) const {
        auto const slope_x = detail::depth_slope(px, 1, 0), slope_y = detail::depth_slope(px, 0, 1);
        // One pixel's change of depth is within what interpolation between taps can be wrong by.
        return Plane<decltype(z + z)>{z, slope_x, slope_y, z * tolerance + abs(slope_x) + abs(slope_y)};
    }
};

/// A normal not turned away from this one. What has none, as a miss, says nothing of the past.
struct SameNormal {
    using reads = Channels<Normal>;
    using remembers = Channels<Normal>;
    float least_cosine = 0.8f;

    template <class Real> struct Facing {
        vec3<Real> n;
        Real least_cosine;
        QUELL_KERNEL auto accepts(auto const& then, Real, Real) const { return dot(n, then[normal]) > least_cosine; }
    };
    QUELL_KERNEL auto around(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const n = px[normal];
        auto const given = detail::is_direction(n);
        return Facing<Real>{select(given, n, zero<vec3<Real>>()), select(given, Real(least_cosine), Real(-1.f))};
    }
};

/// The same object.
struct SameInstance {
    using reads = Channels<Instance>;
    using remembers = Channels<Instance>;

    template <class Real> struct Object {
        Real id;
        QUELL_KERNEL auto accepts(auto const& then, Real, Real) const { return then[instance] == id; }
    };
    QUELL_KERNEL auto around(auto px) const { return Object<typename decltype(px)::Real>{px[instance]}; }
};

/// Every one of several tests.
template <class... Tests> struct AllOf : Tests... {
    using parts = Parts<Tests...>;

    template <class... Prepared> struct Every : Prepared... {
        QUELL_KERNEL auto accepts(auto const& then, auto dx, auto dy) const { return both(Prepared::accepts(then, dx, dy)...); }
    };
    QUELL_KERNEL auto around(auto px) const { return Every<decltype(Tests::around(px))...>{Tests::around(px)...}; }
    QUELL_KERNEL auto around(auto px, auto depth_then) const {
        return Every<decltype(detail::around(static_cast<Tests const&>(*this), px, depth_then))...>{
            detail::around(static_cast<Tests const&>(*this), px, depth_then)...};
    }
};
template <class... Tests> AllOf(Tests...) -> AllOf<Tests...>;

} // namespace quell
