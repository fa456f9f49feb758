#pragma once

#include <quell/motion/reflection/mirror_motion.hpp>

namespace quell {

/// Follows a glossy reflection (TRMV eq. 5): around the place where a mirror would show the hit, every pixel within the lobe shows it too.
/// One of them is drawn, from a Gaussian on the screen whose axes are the projected axes of the ellipse that the lobe, traced from the
/// virtual image towards the mirror, cuts from the tangent plane. The vectors are noisy where the surface is rough: clean up afterwards.
/// Roughness 0 is MirrorMotion exactly. The random numbers are the same in every run.
template <class Mirror = FlatMirror> struct GlossyMotion {
    using parts = Parts<Mirror, SamePlane>;
    using reads = decltype(detail::VirtualImageChannels{} | Channels<Roughness>{});
    static constexpr bool needs_camera = true;
    Mirror mirror{};
    SamePlane test{};
    float spread = 1.f; ///< deviation of the lobe's directions, in GGX alphas

    QUELL_KERNEL auto previous(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const image = detail::virtual_image_then(px, mirror);
        auto const jitter = offset(px, image);
        return test.found(px, vec2<Real>{image.screen.x + jitter.x, image.screen.y + jitter.y}, masked(image.valid, Real(1.f)),
                          image.plane);
    }

private:
    /// From the mirror's place to the drawn one, in pixels.
    template <class Px, class Real> QUELL_KERNEL vec2<Real> offset(Px const& px, detail::VirtualImage<Real> const& image) const {
        auto const& plane = image.plane;
        auto const towards = image.position - broadcast<Real>(px.rays_then().eye);
        auto const steepness = dot(towards, plane.normal), height = dot(plane.point - image.position, plane.normal);
        auto const crosses = both(image.valid, abs(steepness) > Real(1e-6f));
        // The part of the way from the image back to the eye at which the plane lies.
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
        // At grazing angles the far end of the ellipse may lie behind the camera.
        auto const before = screen.z > Real(0.f);
        return {masked(before, screen.x - image.screen.x), masked(before, screen.y - image.screen.y)};
    }
};
template <class Mirror> GlossyMotion(Mirror) -> GlossyMotion<Mirror>;

} // namespace quell
