#pragma once

#include <quell/motion/tangent_plane.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// A test for sources that follow a shadow or a reflection. A past pixel is accepted if it shows the same plane, anywhere on it. The tests
/// of surface_test.hpp demand the same point.
struct SamePlane {
    using remembers = Channels<Depth, Normal>; ///< of the previous frame
    static constexpr int farthest_tap = 0;
    float tolerance = 0.02f; ///< allowed distance from the plane, as a part of the past pixel's depth
    float min_cosine = 0.9f; ///< least cosine of the angle between the normals, now and then

    /// @cond
    template <class Real, class Rays> struct Found {
        vec2<Real> where;
        Real validity;
        detail::Plane<Real> plane;
        Rays const& rays;
        float tolerance, min_cosine;

        QUELL_KERNEL auto accepts(auto const& then, Real, Real) const {
            auto const z = then[depth];
            auto const away = abs(dot(rays.position(then.sample_position(), z) - plane.point, plane.normal));
            auto const off = z * tolerance;
            return both(is_finite(z), away<off, dot(then[normal], plane.normal)> Real(min_cosine));
        }
    };
    /// @endcond
    /// A reprojection with this test. `plane` is the plane in the previous frame, in world space.
    template <class Px, class Real>
    QUELL_KERNEL auto found(Px const& px, vec2<Real> const& where, Real validity, detail::Plane<Real> const& plane) const {
        return Found<Real, std::remove_cvref_t<decltype(px.rays_then())>>{where, validity, plane, px.rays_then(), tolerance, min_cosine};
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
