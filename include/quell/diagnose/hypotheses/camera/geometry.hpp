#pragma once

#include <quell/diagnose/hypotheses/camera/static_motion.hpp>
#include <quell/diagnose/observation.hpp>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// How depth, normals and the cameras of two frames hang together, if the host made a certain mistake or none.
struct Geometry {
    Camera now, then;
    bool ray_length = false;   ///< depth is the length of the ray
    bool view_normals = false; ///< normals are in view space
};

/// How far static surfaces are from where a geometry puts them. Small everywhere for the right one, since the inverse of depth is linear
/// in the pixel on a plane; moving objects and edges never fit.
class GeometryTest {
    Observation const& seen;
    Geometry geometry;
    StaticMotion motion;
    glm::vec2 jitter_change;

public:
    GeometryTest(Observation const& seen_, Geometry const& g)
        : seen(seen_), geometry(g), motion(g.now, g.then, seen_.size), jitter_change(g.now.jitter - g.then.jitter) {}

    /// Relative difference between the depth that the point must have had and the one of the last frame there; empty at edges.
    [[nodiscard]] std::optional<float> of_depth(int x, int y) const {
        if (!seen.depth_then) return std::nullopt;
        auto const then = motion.then(x, y, linear(seen.depth, x, y));
        if (!then) return std::nullopt;
        auto const place = glm::vec2(x, y) + then->motion + jitter_change;
        auto const inverse = inverse_depth_then(place);
        if (!inverse) return std::nullopt;
        return std::abs(1.f - then->depth * *inverse);
    }
    /// Distance between the normal and that of the slope of depth; empty at edges.
    [[nodiscard]] std::optional<float> of_normal(int x, int y) const {
        auto const shown = seen.normal ? shown_normal(x, y) : std::nullopt;
        if (!shown) return std::nullopt;
        auto const n = vec3_at(seen.normal, x, y);
        auto const as_world = glm::normalize(glm::transpose(glm::mat3(geometry.now.view)) * *shown);
        return glm::length(n - (geometry.view_normals ? *shown : as_world));
    }

private:
    /// Along the view axis.
    [[nodiscard]] float linear(Lookup const& depth, int x, int y) const {
        float const d = depth(0, x, y);
        return geometry.ray_length ? d / static_cast<float>(glm::length(motion.point(x, y, 1.f))) : d;
    }
    /// Between four pixels of one surface.
    [[nodiscard]] std::optional<float> inverse_depth_then(glm::vec2 place) const {
        glm::vec2 const last(seen.size.width - 1, seen.size.height - 1);
        if (!(place.x >= 0.f && place.y >= 0.f && place.x < last.x && place.y < last.y)) return std::nullopt;
        int const x = static_cast<int>(place.x), y = static_cast<int>(place.y);
        float const a = linear(seen.depth_then, x, y), b = linear(seen.depth_then, x + 1, y), c = linear(seen.depth_then, x, y + 1),
                    d = linear(seen.depth_then, x + 1, y + 1);
        auto const [least, most] = std::minmax({a, b, c, d});
        if (!is_finite(a + b + c + d) || !(least > 0.f) || most > 1.1f * least) return std::nullopt;
        float const u = place.x - static_cast<float>(x), v = place.y - static_cast<float>(y);
        return (1.f - v) * ((1.f - u) / a + u / b) + v * ((1.f - u) / c + u / d);
    }
    /// In view space, by finite differences, towards the camera.
    [[nodiscard]] std::optional<glm::vec3> shown_normal(int x, int y) const {
        if (x + 1 >= seen.size.width || y + 1 >= seen.size.height) return std::nullopt;
        float const here = linear(seen.depth, x, y), right = linear(seen.depth, x + 1, y), below = linear(seen.depth, x, y + 1);
        auto const beside = [&](float z) { return is_finite(z) && std::abs(z - here) < 0.05f * here; };
        if (!beside(right) || !beside(below)) return std::nullopt;
        auto const p = motion.point(x, y, here);
        auto const n = glm::normalize(glm::cross(motion.point(x, y + 1, below) - p, motion.point(x + 1, y, right) - p));
        return glm::vec3(glm::dot(n, p) < 0. ? n : -n);
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
