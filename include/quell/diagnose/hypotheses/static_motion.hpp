#pragma once

#include <quell/core/real.hpp>
#include <quell/frame/camera.hpp>

#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cmath>
#include <optional>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Finite, and has an inverse.
inline bool invertible(glm::mat4 const& m) {
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r)
            if (!is_finite(m[c][r])) return false;
    return std::abs(glm::determinant(glm::dmat4(m))) > 0.;
}
inline bool nearly(float a, float b) { return std::abs(a - b) < 1e-4f; }

/// Whether a camera is set: a perspective projection that looks down -z, and an invertible view. The default camera is not.
inline bool known(Camera const& camera) {
    auto const& p = camera.projection;
    return invertible(p) && invertible(camera.view) && nearly(p[2][3], -1.f) && nearly(p[3][3], 0.f) && nearly(p[0][3], 0.f) &&
           nearly(p[1][3], 0.f);
}

/// Where a static surface was in the previous frame, from its depth and the two cameras.
class StaticMotion {
    glm::dmat4 view_from_clip, clip_then_from_view;
    glm::dvec2 size, jitter;

public:
    StaticMotion(Camera const& now, Camera const& then, Extent extent)
        : view_from_clip(glm::inverse(glm::dmat4(now.projection))),
          clip_then_from_view(glm::dmat4(then.projection) * glm::dmat4(then.view) * glm::inverse(glm::dmat4(now.view))),
          size(extent.width, extent.height), jitter(now.jitter) {}

    /// The surface point in view space.
    [[nodiscard]] glm::dvec3 point(int x, int y, float depth) const {
        auto const place = place_of(x, y);
        auto const p = view_from_clip * glm::dvec4(place.x / size.x * 2. - 1., 1. - place.y / size.y * 2., 0.5, 1.);
        return glm::dvec3(p) / p.w * (static_cast<double>(depth) * p.w / -p.z);
    }
    /// Motion in pixels, and depth in the previous frame.
    struct Then {
        glm::vec2 motion;
        float depth;
    };
    /// Empty if it was behind the camera.
    [[nodiscard]] std::optional<Then> then(int x, int y, float depth) const {
        auto const clip = clip_then_from_view * glm::dvec4(point(x, y, depth), 1.);
        if (!(clip.w > 1e-6)) return std::nullopt;
        glm::dvec2 const place{(clip.x / clip.w * 0.5 + 0.5) * size.x, (0.5 - 0.5 * clip.y / clip.w) * size.y};
        return Then{glm::vec2(place - place_of(x, y)), static_cast<float>(clip.w)};
    }
    /// Its motion alone.
    [[nodiscard]] std::optional<glm::vec2> at(int x, int y, float depth) const {
        auto const found = then(x, y, depth);
        return found ? std::optional(found->motion) : std::nullopt;
    }

private:
    [[nodiscard]] glm::dvec2 place_of(int x, int y) const { return glm::dvec2(x + 0.5, y + 0.5) + jitter; }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
