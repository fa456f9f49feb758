#pragma once

#include <quell/motion/tangent_plane.hpp>

namespace quell {

/// The test of sources that follow something on or behind a surface and not the surface itself: where they lead, the same plane must be
/// seen again. (Tests in surface_test.hpp ask for the same place on it.)
struct SamePlane {
    using remembers = Channels<Depth, Normal>;
    float tolerance = 0.02f;   ///< how far off the plane a past pixel may be, as a part of its depth
    float least_cosine = 0.9f; ///< between the normals, now and then

    template <class Real> struct Found {
        vec2<Real> where;
        Real validity;
        detail::Plane<Real> plane;
        PixelRays const& rays;
        float tolerance, least_cosine;

        QUELL_KERNEL auto accepts(auto const& then, Real, Real) const {
            auto const z = then[depth];
            auto const away = abs(dot(rays.position(then.sample_position(), z) - plane.point, plane.normal));
            auto const off = z * tolerance;
            return both(is_finite(z), away<off, dot(then[normal], plane.normal)> Real(least_cosine));
        }
    };
    /// A place in the past with this test.
    template <class Px, class Real>
    QUELL_KERNEL Found<Real> found(Px const& px, vec2<Real> const& where, Real validity, detail::Plane<Real> const& plane) const {
        return {where, validity, plane, px.rays_then(), tolerance, least_cosine};
    }
};

} // namespace quell
