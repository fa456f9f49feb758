#pragma once

#include <quell/motion/surface_test.hpp>

namespace quell {

/// Follows the surface seen in the pixel by the host's Motion channel (TRMV eq. 1), and accepts what passes the test.
/// @tparam Test SameDepth, SameNormal, SameInstance, AllOf several, or the host's own
template <class Test = AllOf<SameDepth, SameNormal>> struct SurfaceMotion {
    using parts = Parts<Test>;
    using reads = Channels<Motion>;
    Test test{};

    QUELL_KERNEL auto previous(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const p = px.position(), m = px[motion];
        return detail::TestedReprojection<Real, decltype(test.around(px))>{{p.x + m.x, p.y + m.y}, Real(1.f), test.around(px)};
    }
};
template <class Test> SurfaceMotion(Test) -> SurfaceMotion<Test>;

/// Follows the surface by its previous world position and the previous camera: for hosts that have no Motion channel.
template <class Test = AllOf<SameDepth, SameNormal>> struct PositionMotion {
    using parts = Parts<Test>;
    using reads = Channels<ReceiverPrevious>;
    static constexpr bool needs_camera = true;
    Test test{};

    QUELL_KERNEL auto previous(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const then = px.project_to_past(px[receiver_previous]);
        auto const validity = masked(then.z > Real(0.f), Real(1.f));
        return detail::TestedReprojection<Real, decltype(detail::around(test, px, then.z))>{
            {then.x, then.y}, validity, detail::around(test, px, then.z)};
    }
};
template <class Test> PositionMotion(Test) -> PositionMotion<Test>;

/// Nothing moves: a still camera and still objects. Without a test every past pixel is accepted.
struct StillMotion {
    QUELL_KERNEL auto previous(auto px) const {
        using Real = typename decltype(px)::Real;
        return Reprojection<Real>{px.position(), Real(1.f)};
    }
};

} // namespace quell
