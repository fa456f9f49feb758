#pragma once

#include <quell/frame/cursor/taps.hpp>
#include <quell/motion/same_plane.hpp>

namespace quell {

/// Takes a mirror for flat: the virtual image of a point lies as far behind the plane as the point before it.
struct FlatMirror {
    QUELL_KERNEL auto image(auto const&, auto const& plane, auto const& point) const {
        auto const height = dot(point - plane.point, plane.normal);
        return add_scaled(point, plane.normal, height * -2.f);
    }
};

namespace detail {
/// What a reflected ray hit, as seen in the mirror in the previous frame.
template <class Real> struct VirtualImage {
    Plane<Real> plane; ///< the mirror's
    vec3<Real> position;
    vec3<Real> screen; ///< where the previous frame shows it (pixels), and its depth
    decltype(std::declval<Real>() < std::declval<Real>()) valid;
};

using VirtualImageChannels = decltype(TangentPlaneChannels{} | Channels<GlossyHit, GlossyHitPrevious, Depth>{});

template <class Px> QUELL_KERNEL auto virtual_image_then(Px const& px, auto const& mirror) {
    using Real = typename Px::Real;
    auto const plane = tangent_plane_then(px);
    auto const hit = px[glossy_hit_previous];
    auto const image = mirror.image(px, plane, hit);
    auto const screen = px.project_to_past(image);
    auto const valid = both(all_finite(hit), all_finite(px[glossy_hit]), dot(hit - plane.point, plane.normal) > Real(0.f),
                            screen.z > Real(0.f), is_finite(screen.x), is_finite(screen.y));
    return VirtualImage<Real>{plane, image, screen, valid};
}
} // namespace detail

/// Follows the virtual image in a mirror and not the mirror (Zimmer 2015, Mara 2017; TRMV eq. 5 without its spread): what the reflected ray
/// hit is moved to the previous frame, mirrored at the previous tangent plane, and projected. Invalid where the ray hit nothing, where the
/// hit is not before the plane, behind the camera, and for anything not finite.
/// @tparam Mirror where the virtual image is: FlatMirror, or ThinLens for curved mirrors
template <class Mirror = FlatMirror> struct MirrorMotion {
    using parts = Parts<Mirror, SamePlane>;
    using reads = detail::VirtualImageChannels;
    static constexpr bool needs_camera = true;
    Mirror mirror{};
    SamePlane test{};

    QUELL_KERNEL auto previous(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const image = detail::virtual_image_then(px, mirror);
        return test.found(px, vec2<Real>{image.screen.x, image.screen.y}, masked(image.valid, Real(1.f)), image.plane);
    }
};
template <class Mirror> MirrorMotion(Mirror) -> MirrorMotion<Mirror>;

/// Follows the virtual image like MirrorMotion, but by how far the image has moved on the screen since the previous frame, not to where it
/// was. A rough surface shows a hit in many pixels around the mirror direction's: each of them keeps its own place in the lobe, so what
/// stands still stays exactly where it is, with no noise in the vectors.
template <class Mirror = FlatMirror> struct ImageMotion {
    using parts = Parts<Mirror, SamePlane>;
    using reads = detail::VirtualImageChannels;
    static constexpr bool needs_camera = true;
    Mirror mirror{};
    SamePlane test{};
    float among_moving = 0.5f; ///< validity where neighbouring pixels reflect something that moves: their mixture follows no single vector

    QUELL_KERNEL auto previous(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const image = detail::virtual_image_then(px, mirror);
        detail::Plane<Real> const plane_now{px[position], px[normal]};
        auto const now = px.project(mirror.image(px, plane_now, px[glossy_hit]));
        auto const p = px.position();
        auto const x = p.x + (image.screen.x - now.x), y = p.y + (image.screen.y - now.y);
        auto const valid = both(image.valid, now.z > Real(0.f), is_finite(x), is_finite(y));
        return test.found(px, vec2<Real>{x, y}, masked(valid, trust(px)), image.plane);
    }

private:
    template <class Px> QUELL_KERNEL auto trust(Px const& px) const {
        using Real = typename Px::Real;
        Real moving(0.f);
        for_each_neighbour<1>(px, [&](auto neighbour, auto inside, int, int) QUELL_INLINED {
            auto const hit = neighbour[glossy_hit], way = hit - neighbour[glossy_hit_previous], from_here = hit - neighbour[position];
            moving = max(moving, masked(dot(way, way) > dot(from_here, from_here) * 1e-8f, inside));
        });
        return select(moving > Real(0.f), Real(among_moving), Real(1.f));
    }
};
template <class Mirror> ImageMotion(Mirror) -> ImageMotion<Mirror>;

} // namespace quell
