#pragma once

#include <quell/motion/surface_test.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Follows the surface by the host's Motion channel (TRMV eq. 1). Validity is 1.
/// @tparam Test SameDepth, SameNormal, SameInstance, AllOf several, or the host's own
template <class Test = AllOf<SameDepth, SameNormal>> struct SurfaceMotion {
    static_assert(detail::is_surface_test<Test>,
                  "SurfaceMotion{test}: `test` must have around(px), whose result has accepts(then, dx, dy), "
                  "see quell/motion/surface_test.hpp");
    using parts = Parts<Test>;      ///< what it is made of
    using reads = Channels<Motion>; ///< of this frame
    static constexpr int farthest_tap = 0;
    Test test{}; ///< what a past pixel must pass

    /// See MotionSource.
    QUELL_KERNEL auto previous(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const p = px.position(), m = px[motion];
        return TestedReprojection<Real, decltype(test.around(px))>{{p.x + m.x, p.y + m.y}, Real(1.f), test.around(px)};
    }
};
template <class Test> SurfaceMotion(Test) -> SurfaceMotion<Test>;

/// Follows the surface by its previous world-space position and the previous camera, for hosts without a Motion channel. Validity is 1, or
/// 0 behind the camera.
/// @tparam Test SameDepth, SameNormal, SameInstance, AllOf several, or the host's own
template <class Test = AllOf<SameDepth, SameNormal>> struct PositionMotion {
    static_assert(detail::is_surface_test<Test>,
                  "PositionMotion{test}: `test` must have around(px), whose result has accepts(then, dx, dy), "
                  "see quell/motion/surface_test.hpp");
    using parts = Parts<Test>;                 ///< what it is made of
    using reads = Channels<ReceiverPrevious>;  ///< of this frame
    static constexpr bool needs_camera = true; ///< to project
    static constexpr int farthest_tap = 0;
    Test test{}; ///< what a past pixel must pass

    /// See MotionSource.
    QUELL_KERNEL auto previous(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const then = px.project_to_past(px[receiver_previous]);
        auto const validity = masked(then.z > Real(0.f), Real(1.f));
        return TestedReprojection<Real, decltype(detail::around(test, px, then.z))>{
            {then.x, then.y}, validity, detail::around(test, px, then.z)};
    }
};
template <class Test> PositionMotion(Test) -> PositionMotion<Test>;

/// For a still camera and still objects: the same pixel, validity 1. It has no test.
struct StillMotion {
    static constexpr int farthest_tap = 0;
    /// See MotionSource.
    QUELL_KERNEL auto previous(auto px) const {
        using Real = typename decltype(px)::Real;
        return Reprojection<Real>{px.position(), Real(1.f)};
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
