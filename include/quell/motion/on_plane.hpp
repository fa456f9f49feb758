#pragma once

#include <quell/motion/tangent_plane.hpp>

namespace quell::detail {

/// A place in the past where the same plane must be seen again: the test of sources that follow something on or behind a surface, and not
/// the surface itself.
template <class Real> struct ReprojectionOnPlane {
    vec2<Real> where;
    Real validity;
    Plane<Real> plane;
    PixelRays const& rays;
    float tolerance;    ///< allowed distance from the plane, as a part of the depth
    float least_cosine; ///< between the normals

    QUELL_KERNEL auto accepts(auto const& then, Real, Real) const {
        auto const z = then[depth];
        vec2<Real> const centre{then.place.column + (static_cast<float>(then.dx) + 0.5f),
                                then.place.row + (static_cast<float>(then.dy) + 0.5f)};
        auto const away = abs(dot(rays.position(centre, z) - plane.point, plane.normal));
        return both(is_finite(z), away<z * tolerance, dot(then[normal], plane.normal)> Real(least_cosine));
    }
};

} // namespace quell::detail
