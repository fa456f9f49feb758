#pragma once

#include <quell/frame/cursor/taps.hpp>
#include <quell/motion/same_plane.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// The virtual image in a flat mirror: the point reflected at the tangent plane.
struct FlatMirror {
    static constexpr int farthest_tap = 0;
    /// The virtual image of `point`. All in world space.
    QUELL_KERNEL auto image(auto const&, auto const& plane, auto const& point) const {
        auto const height = dot(point - plane.point, plane.normal);
        return add_scaled(point, plane.normal, height * -2.f);
    }
};

namespace detail {
/// The virtual image of a reflected hit in the previous frame.
template <class Real> struct VirtualImage {
    Plane<Real> plane;   ///< the mirror's
    vec3<Real> position; ///< world space
    vec3<Real> screen;   ///< pixel coordinates and linear depth
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

/// Follows the virtual image in a mirror instead of the mirror's surface (Zimmer et al. 2015, Mara et al. 2017; TRMV eq. 5 without the
/// spread). The previous position of the reflected hit is mirrored at the previous tangent plane and projected by the previous camera.
/// Validity is 1, or 0 where the ray hit nothing, the hit is not in front of the plane, the image is behind the camera, or a position is
/// not finite.
/// @tparam Mirror computes the virtual image: FlatMirror, or ThinLens for curved mirrors
template <class Mirror = FlatMirror> struct MirrorMotion {
    using parts = Parts<Mirror, SamePlane>;     ///< what it is made of
    using reads = detail::VirtualImageChannels; ///< of this frame
    static constexpr bool needs_camera = true;  ///< to project
    static constexpr int farthest_tap = 1;
    Mirror mirror{};  ///< computes the virtual image
    SamePlane test{}; ///< what a past pixel must pass

    /// See MotionSource.
    QUELL_KERNEL auto previous(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const image = detail::virtual_image_then(px, mirror);
        return test.found(px, vec2<Real>{image.screen.x, image.screen.y}, masked(image.valid, Real(1.f)), image.plane);
    }
};
template <class Mirror> MirrorMotion(Mirror) -> MirrorMotion<Mirror>;

/// Moves the pixel by the displacement of the virtual image on the screen since the previous frame; MirrorMotion goes to the image's
/// position itself. On a rough surface each pixel then keeps its place within the lobe: vectors have no noise, and a still picture stays
/// still.
/// @tparam Mirror computes the virtual image: FlatMirror, or ThinLens for curved mirrors
template <class Mirror = FlatMirror> struct ImageMotion {
    using parts = Parts<Mirror, SamePlane>;     ///< what it is made of
    using reads = detail::VirtualImageChannels; ///< of this frame
    static constexpr bool needs_camera = true;  ///< to project
    static constexpr int farthest_tap = 1;
    Mirror mirror{};           ///< computes the virtual image
    SamePlane test{};          ///< what a past pixel must pass
    float among_moving = 0.5f; ///< validity where something reflected in the 3x3 moves: no single vector fits the mixture

    /// See MotionSource.
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
    /// `among_moving` where a hit of the 3x3 has moved since the previous frame by more than 1e-4 of its distance, else 1.
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

} // namespace quell::inline QUELL_INSTRUCTION_SET
