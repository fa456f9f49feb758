#pragma once

#include <quell/core/value.hpp>
#include <quell/frame/camera.hpp>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Converts pixel coordinates and linear depth to world space, for perspective cameras:
/// position = eye + depth * (forward + where.x * right + where.y * down).
struct PixelRays {
    glm::vec3 eye{0.f};                ///< world-space position of the camera
    glm::vec3 forward{0.f, 0.f, -1.f}; ///< from the eye to the image's top left corner at depth 1
    glm::vec3 right{0.f},              ///< from a pixel to the one on the right, at depth 1
        down{0.f};                     ///< from a pixel to the one below, at depth 1
    float pixel_size = 0.f;            ///< side of a pixel at depth 1, world units

    PixelRays() = default; ///< a placeholder: all rays coincide
    /// The rays of an image of `size` pixels. Jitter is not applied.
    PixelRays(Camera const& camera, Extent size) {
        auto const unproject = glm::inverse(camera.projection);
        auto const to_world = glm::inverse(camera.view);
        auto const direction = [&](float x, float y) {
            auto const p = unproject * glm::vec4(x, y, 0.5f, 1.f);
            auto const in_view = glm::vec3(p) / p.w;
            return glm::vec3(to_world * glm::vec4(in_view / -in_view.z, 0.f));
        };
        eye = glm::vec3(to_world[3]);
        forward = direction(-1.f, 1.f);
        right = (direction(1.f, 1.f) - forward) / static_cast<float>(size.width);
        down = (direction(-1.f, -1.f) - forward) / static_cast<float>(size.height);
        pixel_size = 0.5f * (glm::length(right) + glm::length(down));
    }

    /// World-space direction of the ray through `where` (pixel coordinates), scaled to depth 1.
    template <class Real> QUELL_KERNEL vec3<Real> direction(vec2<Real> const& where) const {
        return {fma(where.x, Real(right.x), fma(where.y, Real(down.x), Real(forward.x))),
                fma(where.x, Real(right.y), fma(where.y, Real(down.y), Real(forward.y))),
                fma(where.x, Real(right.z), fma(where.y, Real(down.z), Real(forward.z)))};
    }
    /// World-space point at `where` (pixel coordinates) and a linear depth.
    template <class Real> QUELL_KERNEL vec3<Real> position(vec2<Real> const& where, Real linear_depth) const {
        auto const d = direction(where);
        return {fma(d.x, linear_depth, Real(eye.x)), fma(d.y, linear_depth, Real(eye.y)), fma(d.z, linear_depth, Real(eye.z))};
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
