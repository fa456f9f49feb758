#pragma once

#include <quell/motion/motion_source.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// A plane through a point, with a unit normal.
template <class Real> struct Plane { vec3<Real> point, normal; };

template <class Real> QUELL_KERNEL vec3<Real> cross(vec3<Real> const& a, vec3<Real> const& b) {
    return {fma(a.y, b.z, -(a.z * b.y)), fma(a.z, b.x, -(a.x * b.z)), fma(a.x, b.y, -(a.y * b.x))};
}
/// a / |a|; vectors shorter than 1e-15 come out shorter than 1.
template <class Real> QUELL_KERNEL vec3<Real> normalized(vec3<Real> const& a) { return scale(a, 1.f / sqrt(max(dot(a, a), Real(1e-30f)))); }
template <class Real> QUELL_KERNEL Real length(vec3<Real> const& a) { return sqrt(dot(a, a)); }

/// What tangent_plane_then reads.
using TangentPlaneChannels = Channels<Position, ReceiverPrevious, Normal>;

/// The edge from a pixel's surface point to a neighbour's along (dx, dy), now and in the previous frame. Of both sides the shorter edge is
/// taken, since the longer one may cross a silhouette.
template <class Px> struct SurfaceEdge {
    using Real = typename Px::Real;
    vec3<Real> now, then;

    QUELL_KERNEL SurfaceEdge(Px const& px, vec3<Real> const& here, vec3<Real> const& here_then, int dx, int dy) {
        auto const forth = px.at(dx, dy), back = px.at(-dx, -dy);
        auto const ahead = forth[position] - here, behind = here - back[position];
        auto const use_ahead = both(forth.inside(), either(invert(back.inside()), dot(ahead, ahead) <= dot(behind, behind)));
        now = select(use_ahead, ahead, behind);
        then = select(use_ahead, forth[receiver_previous] - here_then, here_then - back[receiver_previous]);
    }
};

/// The tangent plane, in the previous frame, of the surface point seen in a pixel. There is no channel of previous normals: for points that
/// moved, the normal is corrected by the change of the triangle of neighbouring surface points.
template <class Px> QUELL_KERNEL auto tangent_plane_then(Px const& px) {
    using Real = typename Px::Real;
    auto const now = px[position], then = px[receiver_previous];
    auto n = px[normal];
    auto const moved = then - now;
    auto const from_eye = now - broadcast<Real>(px.rays().eye);
    auto const has_moved = dot(moved, moved) > dot(from_eye, from_eye) * 1e-12f;
    if (any(has_moved)) {
        SurfaceEdge<Px> const across(px, now, then, 1, 0), down(px, now, then, 0, 1);
        // The triangle's normal faces the camera; the shading normal may face away.
        auto const face = normalized(cross(down.now, across.now));
        auto const side = select(dot(n, face) < Real(0.f), Real(-1.f), Real(1.f));
        auto const turned = add_scaled(n, normalized(cross(down.then, across.then)) - face, side);
        n = select(both(has_moved, all_finite(turned)), normalized(turned), n);
    }
    return Plane<Real>{then, n};
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
