#pragma once

#include <quell/diagnose/hypotheses/static_motion.hpp>
#include <quell/diagnose/observation.hpp>
#include <quell/diagnose/statistics.hpp>

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
    float unit = 1.f;          ///< of depth, in units of the camera's position
    /// Depth is a value that goes like its inverse, beginning with this: 0 for the inverse itself and for reversed depth buffers, about 1
    /// for others. The unit is unknown.
    std::optional<float> inverse_from{};
    /// Depth is that of a sample anywhere in the pixel. It is taken for the centre's, so that all tests need a margin.
    bool scattered = false;
};

/// How far something is from where it should be, and how far it may be where all is well.
struct Residual {
    float value, noise;
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
    [[nodiscard]] std::optional<Residual> of_depth(int x, int y) const {
        if (!seen.depth_then || geometry.inverse_from) return std::nullopt;
        auto const then = motion.then(x, y, linear(seen.depth, x, y));
        if (!then) return std::nullopt;
        auto const place = glm::vec2(x, y) + then->motion + jitter_change;
        auto const inverse = inverse_depth_then(place);
        auto const slope = geometry.scattered ? slope_around(x, y) : 0.f;
        if (!inverse || !slope) return std::nullopt;
        // Both depths are off by up to half a pixel in x and in y.
        return Residual{std::abs(1.f - then->depth * *inverse), 0.35f * *slope};
    }
    /// Distance between the normal and that of the slope of depth; empty at edges.
    [[nodiscard]] std::optional<Residual> of_normal(int x, int y) const {
        int const reach = seen.normal ? reach_of_normal(x, y) : 0;
        auto const shown = reach > 0 ? shown_normal(x, y, reach) : std::nullopt;
        if (!shown) return std::nullopt;
        auto const n = vec3_at(seen.normal, x, y);
        auto const as_world = glm::normalize(glm::transpose(glm::mat3(geometry.now.view)) * *shown);
        auto const off = glm::length(n - (geometry.view_normals ? *shown : as_world));
        return Residual{off, geometry.scattered ? 0.4f / static_cast<float>(reach) : 0.f};
    }

private:
    /// Along the view axis.
    [[nodiscard]] float linear(Lookup const& depth, int x, int y) const {
        float const given = depth(0, x, y),
                    d = geometry.inverse_from ? 1.f / std::abs(given - *geometry.inverse_from) : geometry.unit * given;
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
    [[nodiscard]] std::optional<glm::vec3> shown_normal(int x, int y, int reach) const {
        if (x + reach >= seen.size.width || y + reach >= seen.size.height) return std::nullopt;
        float const here = linear(seen.depth, x, y), right = linear(seen.depth, x + reach, y), below = linear(seen.depth, x, y + reach);
        float const allowed = std::min(0.05f * static_cast<float>(reach), 0.5f);
        auto const beside = [&](float z) { return is_finite(z) && std::abs(z - here) < allowed * here; };
        if (!beside(right) || !beside(below)) return std::nullopt;
        auto const p = motion.point(x, y, here);
        auto const n = glm::normalize(glm::cross(motion.point(x, y + reach, below) - p, motion.point(x + reach, y, right) - p));
        return glm::vec3(glm::dot(n, p) < 0. ? n : -n);
    }
    /// How far to go for a slope: the farther, the less samples beside the centres matter; 0 where the plane ends before that.
    [[nodiscard]] int reach_of_normal(int x, int y) const {
        if (!geometry.scattered) return 1;
        for (int const part : {8, 12, 20}) {
            int const reach = std::max(4, seen.size.width / part);
            if (is_plane(x, y, reach, 0) && is_plane(x, y, 0, reach)) return reach;
        }
        return 0;
    }
    /// Whether the pixels from one to another are of one plane: their normals are the same, and the inverse of depth is even.
    [[nodiscard]] bool is_plane(int x, int y, int right, int down) const {
        if (x + right >= seen.size.width || y + down >= seen.size.height) return false;
        int const i = x + right / 2, j = y + down / 2;
        auto const n = vec3_at(seen.normal, x, y);
        if (glm::length(n - vec3_at(seen.normal, i, j)) > 1e-3f || glm::length(n - vec3_at(seen.normal, x + right, y + down)) > 1e-3f)
            return false;
        float const middle = linear(seen.depth, i, j), a = middle / linear(seen.depth, x, y),
                    b = middle / linear(seen.depth, x + right, y + down);
        return std::abs(a + b - 2.f) < 1e-3f + 3.f * slope_around(x, y).value_or(0.f);
    }
    /// Relative change of depth from a pixel to the next, of x and y together; empty at edges.
    [[nodiscard]] std::optional<float> slope_around(int x, int y) const {
        constexpr int reach = 3;
        if (x < reach || y < reach || x + reach >= seen.size.width || y + reach >= seen.size.height) return std::nullopt;
        float const z = seen.depth(0, x, y);
        auto const across = glm::vec2(seen.depth(0, x + reach, y) - seen.depth(0, x - reach, y),
                                      seen.depth(0, x, y + reach) - seen.depth(0, x, y - reach)) /
                            (2.f * reach * z);
        float const slope = glm::length(across);
        return is_finite(slope) && slope < 0.1f ? std::optional(slope) : std::nullopt;
    }
};

/// Whether depths lie beside the pixels' centres, each somewhere else: on a plane the inverse of depth then bends from pixel to pixel by
/// about half of what it rises. Depths of few bits look the same, and want the same margin.
inline bool is_scattered(Observation const& seen) {
    std::vector<float> bends;
    for_each_hit(seen, [&](int x, int y) {
        if (x < 1 || x + 1 >= seen.size.width) return;
        float const left = seen.depth(0, x - 1, y), here = seen.depth(0, x, y), right = seen.depth(0, x + 1, y);
        float const rise = here / left - here / right, bend = here / left + here / right - 2.f;
        bool const one_surface =
            is_finite(rise) && std::abs(rise) > 1e-4f && std::abs(here / left - 1.f) < 0.05f && std::abs(here / right - 1.f) < 0.05f;
        if (!one_surface) return;
        auto const same = [&](int i) { return glm::length(vec3_at(seen.normal, x, y) - vec3_at(seen.normal, i, y)) < 1e-3f; };
        if (!seen.normal || (same(x - 1) && same(x + 1))) bends.push_back(std::abs(bend / rise));
    });
    return bends.size() >= 50 && median(bends) > 0.1f;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
