#pragma once

#include <quell/motion/reflection/mirror_motion.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Follows a glossy reflection (TRMV eq. 5). A rough surface shows the hit in all pixels within the lobe around the mirror position; one of
/// them is drawn at random from a screen-space Gaussian. Its axes are the projected axes of the ellipse in which the lobe around the ray
/// from the virtual image to the eye intersects the tangent plane. Vectors are noisy on rough surfaces: follow with a clean-up filter. At
/// roughness 0 it equals MirrorMotion. The random numbers are the same in every run.
/// @tparam Mirror computes the virtual image: FlatMirror, or ThinLens for curved mirrors
template <class Mirror = FlatMirror> struct GlossyMotion {
    using parts = Parts<Mirror, SamePlane>;                                         ///< what it is made of
    using reads = decltype(detail::VirtualImageChannels{} | Channels<Roughness>{}); ///< of this frame
    static constexpr bool needs_camera = true;                                      ///< to project
    static constexpr int farthest_tap = 1;
    Mirror mirror{};    ///< computes the virtual image
    SamePlane test{};   ///< what a past pixel must pass
    float spread = 1.f; ///< standard deviation of the tangent of the lobe's angle, as a multiple of GGX alpha

    /// See MotionSource.
    QUELL_KERNEL auto previous(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const image = detail::virtual_image_then(px, mirror);
        auto const jitter = offset(px, image);
        return test.found(px, vec2<Real>{image.screen.x + jitter.x, image.screen.y + jitter.y}, masked(image.valid, Real(1.f)),
                          image.plane);
    }

private:
    /// Random offset from the mirror position, in pixels.
    template <class Px, class Real> QUELL_KERNEL vec2<Real> offset(Px const& px, detail::VirtualImage<Real> const& image) const {
        auto const& plane = image.plane;
        auto const towards = image.position - broadcast<Real>(px.rays_then().eye);
        auto const steepness = dot(towards, plane.normal), height = dot(plane.point - image.position, plane.normal);
        auto const crosses = both(image.valid, abs(steepness) > Real(1e-6f));
        // Where the segment from the image to the eye meets the plane: 0 at the image, 1 at the eye.
        auto const part = -height / select(crosses, steepness, Real(1.f));
        auto const centre = add_scaled(image.position, towards, -part);
        auto const alpha = px[roughness] * px[roughness];
        auto const reach = part * detail::length(towards) * alpha * spread;
        auto const direction = detail::normalized(towards);
        auto const minor = detail::normalized(detail::cross(direction, plane.normal));
        auto const major = detail::cross(plane.normal, minor);
        auto const cosine = max(abs(dot(direction, plane.normal)), Real(0.1f));
        auto const a = end_point(px, image, add_scaled(centre, minor, reach)),
                   b = end_point(px, image, add_scaled(centre, major, reach / cosine));
        auto const [first, second] = px.random_normals();
        vec2<Real> const moved{first * a.x + second * b.x, first * a.y + second * b.y};
        auto const usable = both(crosses, reach > Real(0.f), is_finite(moved.x), is_finite(moved.y));
        return {masked(usable, moved.x), masked(usable, moved.y)};
    }
    template <class Px, class Real>
    QUELL_KERNEL static vec2<Real> end_point(Px const& px, detail::VirtualImage<Real> const& image, vec3<Real> const& point) {
        auto const screen = px.project_to_past(point);
        // At grazing angles the ellipse may reach behind the camera.
        auto const before = screen.z > Real(0.f);
        return {masked(before, screen.x - image.screen.x), masked(before, screen.y - image.screen.y)};
    }
};
template <class Mirror> GlossyMotion(Mirror) -> GlossyMotion<Mirror>;

} // namespace quell::inline QUELL_INSTRUCTION_SET
