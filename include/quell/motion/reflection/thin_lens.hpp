#pragma once

#include <quell/motion/tangent_plane.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// The virtual image in a curved mirror, for MirrorMotion and ImageMotion (TRMV section 7; Hirvonen et al. 2019). It applies
/// the thin-lens equation, 1 / image distance = 1 / object distance + 2 / radius, in two directions of the surface. Curvatures come from
/// the normals of neighbouring pixels in this frame and are used for the previous frame too. Convex mirrors bring the image closer.
struct ThinLens {
    using reads = Channels<Position, ReceiverPrevious, Normal>; ///< of this frame
    static constexpr int farthest_tap = 1;
    float max_curvature = 50.f; ///< limit of the absolute curvature, in 1 / world units

    /// The virtual image of `point`. All in world space.
    template <class Px, class Plane, class V> QUELL_KERNEL V image(Px const& px, Plane const& plane, V const& point) const {
        auto const offset = point - plane.point;
        auto const mirrored = add_scaled(offset, plane.normal, dot(offset, plane.normal) * -2.f);
        auto const distance = detail::length(offset);
        auto const here = px[position];
        detail::SurfaceEdge<Px> const across(px, here, here, 1, 0), down(px, here, here, 0, 1);
        auto const first = detail::normalized(add_scaled(across.now, plane.normal, -dot(across.now, plane.normal)));
        auto const second = detail::cross(plane.normal, first);
        auto const along_first = shrink(curvature(px, across.now, 1, 0), distance);
        auto const along_second = shrink(curvature(px, down.now, 0, 1), distance);
        auto const image = add_scaled(
            add_scaled(add_scaled(plane.point, first, dot(mirrored, first) * along_first), second, dot(mirrored, second) * along_second),
            plane.normal, dot(mirrored, plane.normal) * (along_first + along_second) * 0.5f);
        auto const flat = plane.point + mirrored;
        return select(both(all_finite(image), is_finite(distance)), image, flat);
    }

private:
    /// Curvature of the surface along one screen direction, in 1 / world units; positive is convex.
    template <class Px, class V> QUELL_KERNEL auto curvature(Px const& px, V const& edge, int dx, int dy) const {
        using Real = typename Px::Real;
        auto const forth = px.at(dx, dy), back = px.at(-dx, -dy);
        auto const span = forth[position] - back[position], turn = forth[normal] - back[normal];
        // Across a silhouette the span is much longer than the shorter edge.
        auto const smooth = both(forth.inside(), back.inside(), dot(span, span) < dot(edge, edge) * 9.f);
        auto const bend = dot(turn, span) / max(dot(span, span), Real(1e-20f));
        return masked(both(smooth, is_finite(bend)), clamp(bend, Real(-max_curvature), Real(max_curvature)));
    }
    /// Image distance / object distance.
    template <class Real> QUELL_KERNEL static Real shrink(Real curvature, Real distance) {
        // In a concave mirror the image may pass through infinity and become real. The bound keeps it at 5 times the object distance.
        return 1.f / max(fma(curvature * 2.f, distance, Real(1.f)), Real(0.2f));
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
