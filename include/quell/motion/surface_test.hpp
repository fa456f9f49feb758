#pragma once

#include <quell/frame/cursor/depth_slope.hpp>
#include <quell/motion/motion_source.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

// Tests of whether a past pixel shows the same surface as this pixel. `around(px)` prepares what does not depend on the tap. Its result has
// `accepts(then, dx, dy)`, which tests one tap, (dx, dy) pixels from the reprojected position. A test may also have `around(px,
// depth_then)`, for sources that know the surface's linear depth in the previous frame.

namespace detail {
template <class Test> QUELL_KERNEL auto around(Test const& test, auto px, auto depth_then) {
    if constexpr (requires { test.around(px, depth_then); })
        return test.around(px, depth_then);
    else
        return test.around(px);
}
template <class Test>
concept SurfaceTest = requires(Test const& test, Probe<Test> px, PastProbe<Test> then) {
    test.around(px).accepts(then, 0.f, 0.f);
};
/// Whether a test has what sources call, and each part of an AllOf.
template <class Test> inline constexpr bool is_surface_test = SurfaceTest<Test>;
/// Whether a vector is finite and at least 0.5 long: a usable normal.
template <class Real> QUELL_KERNEL auto is_direction(vec3<Real> const& n) { return both(all_finite(n), dot(n, n) > Real(0.25f)); }
} // namespace detail

/// What a motion source returns that tests the past pixels it leads to: Reprojection, and the test that its taps must pass.
/// @tparam Prepared what `around(px)` of a test returns
template <class Real, class Prepared> struct TestedReprojection {
    vec2<Real> where; ///< pixel coordinates in the previous frame
    Real validity;    ///< trust in [0, 1]
    Prepared test;    ///< accepts(then, dx, dy)

    /// Whether the past pixel `then`, (dx, dy) pixels from `where`, counts.
    QUELL_KERNEL auto accepts(auto const& then, Real dx, Real dy) const { return test.accepts(then, dx, dy); }
};

/// Accepts a past pixel whose depth lies near the plane through this pixel's depth and depth slopes. A miss accepts misses only.
struct SameDepth {
    using reads = Channels<Depth>;     ///< of this frame
    using remembers = Channels<Depth>; ///< of the previous frame
    static constexpr int farthest_tap = 1;
    /// Allowed difference from the plane, as a part of the depth. Sources that do not know the depth in the previous frame use this
    /// frame's: it then also limits how much depth may change in a frame.
    float tolerance = 0.05f;

    /// @cond
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
        // Interpolation between taps may be off by the depth difference of one pixel.
        return Plane<decltype(z + z)>{z, slope_x, slope_y, z * tolerance + abs(slope_x) + abs(slope_y)};
    }
    /// @endcond
};

/// Accepts a past pixel whose normal is within an angle of this pixel's. A pixel without a normal, such as a miss, accepts every past
/// pixel.
struct SameNormal {
    using reads = Channels<Normal>;     ///< of this frame
    using remembers = Channels<Normal>; ///< of the previous frame
    static constexpr int farthest_tap = 0;
    float min_cosine = 0.8f; ///< of the angle between the normals

    /// @cond
    template <class Real> struct Facing {
        vec3<Real> n;
        Real min_cosine;
        QUELL_KERNEL auto accepts(auto const& then, Real, Real) const { return dot(n, then[normal]) > min_cosine; }
    };
    QUELL_KERNEL auto around(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const n = px[normal];
        auto const given = detail::is_direction(n);
        return Facing<Real>{select(given, n, zero<vec3<Real>>()), select(given, Real(min_cosine), Real(-1.f))};
    }
    /// @endcond
};

/// Accepts a past pixel of the same object.
struct SameInstance {
    using reads = Channels<Instance>;     ///< of this frame
    using remembers = Channels<Instance>; ///< of the previous frame
    static constexpr int farthest_tap = 0;

    /// @cond
    template <class Real> struct Object {
        Real id;
        QUELL_KERNEL auto accepts(auto const& then, Real, Real) const { return then[instance] == id; }
    };
    QUELL_KERNEL auto around(auto px) const { return Object<typename decltype(px)::Real>{px[instance]}; }
    /// @endcond
};

/// Accepts a past pixel that passes all of several tests.
/// @tparam Tests any surface tests
template <class... Tests> struct AllOf : Tests... {
    using parts = Parts<Tests...>; ///< what it is made of

    /// @cond
    template <class... Prepared> struct Every : Prepared... {
        QUELL_KERNEL auto accepts([[maybe_unused]] auto const& then, auto dx, [[maybe_unused]] auto dy) const {
            if constexpr (sizeof...(Prepared) == 0)
                return abs(dx) >= decltype(dx)(0.f); // always
            else
                return both(Prepared::accepts(then, dx, dy)...);
        }
    };
    QUELL_KERNEL auto around(auto px) const { return Every<decltype(Tests::around(px))...>{Tests::around(px)...}; }
    QUELL_KERNEL auto around(auto px, auto depth_then) const {
        return Every<decltype(detail::around(static_cast<Tests const&>(*this), px, depth_then))...>{
            detail::around(static_cast<Tests const&>(*this), px, depth_then)...};
    }
    /// @endcond
};
template <class... Tests> AllOf(Tests...) -> AllOf<Tests...>;
template <class... Tests> inline constexpr bool detail::adds_no_tap<AllOf<Tests...>> = true;
/// @cond
template <class... Tests> inline constexpr bool detail::is_surface_test<AllOf<Tests...>> = (SurfaceTest<Tests> && ...);
/// @endcond

} // namespace quell::inline QUELL_INSTRUCTION_SET
