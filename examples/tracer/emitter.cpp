#include "emitter.hpp"
#include "basis.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace quell::tracer {
namespace {

constexpr float pi = std::numbers::pi_v<float>;
constexpr int candidate_count = 8;

/// A convex polygon around the receiver at the origin, of the part above the horizon.
struct Polygon {
    std::array<glm::vec3, 5> corners{};
    int count = 0;
    void push(glm::vec3 corner) { corners[static_cast<std::size_t>(count++)] = corner; }
    [[nodiscard]] glm::vec3 operator[](int i) const { return corners[static_cast<std::size_t>(i)]; }
};

/// Sutherland-Hodgman against the plane of the horizon.
Polygon above_horizon(Emitter const& emitter, glm::vec3 position, glm::vec3 normal) {
    Polygon clipped;
    for (int i = 0; i < emitter.corner_count; ++i) {
        auto const a = emitter.corners[static_cast<std::size_t>(i)] - position;
        auto const b = emitter.corners[static_cast<std::size_t>((i + 1) % emitter.corner_count)] - position;
        float const above_a = glm::dot(a, normal), above_b = glm::dot(b, normal);
        if (above_a >= 0) clipped.push(a);
        if ((above_a >= 0) != (above_b >= 0)) clipped.push(glm::mix(a, b, above_a / (above_a - above_b)));
    }
    return clipped;
}

/// One edge's part of Lambert's formula: the angle that it subtends times the cosine of its plane.
float edge_term(glm::vec3 a, glm::vec3 b, glm::vec3 normal) {
    auto const cross = glm::cross(a, b);
    float const length = glm::length(cross);
    return length > 0 ? std::atan2(length, glm::dot(a, b)) / length * glm::dot(cross, normal) : 0.f;
}

bool shows_its_dark_side(Emitter const& emitter, glm::vec3 position) {
    auto const normal = glm::cross(emitter.corners[1] - emitter.corners[0], emitter.corners[2] - emitter.corners[0]);
    return !emitter.both_sides && glm::dot(normal, position - emitter.corners[0]) <= 0;
}

float polygon_irradiance(Emitter const& emitter, glm::vec3 position, glm::vec3 normal) {
    if (shows_its_dark_side(emitter, position)) return 0;
    auto const polygon = above_horizon(emitter, position, normal);
    float sum = 0;
    for (int i = 0; i < polygon.count; ++i) sum += edge_term(polygon[i], polygon[(i + 1) % polygon.count], normal);
    return std::abs(sum) * 0.5f;
}

float sphere_irradiance(Emitter const& emitter, glm::vec3 position, glm::vec3 normal) {
    auto const offset = emitter.centre - position;
    float const distance2 = glm::dot(offset, offset), sine2 = emitter.radius * emitter.radius / distance2;
    if (sine2 >= 1) return pi;
    float const cosine = glm::clamp(glm::dot(offset, normal) / std::sqrt(distance2), -1.f, 1.f);
    if (cosine * cosine >= sine2) return cosine > 0 ? pi * sine2 * cosine : 0;
    // The horizon cuts the cap: Snyder's integral, in terms of the cotangents of the cap's angle and of its centre's.
    float const sine_centre = std::sqrt(1 - cosine * cosine), cotangent_cap = std::sqrt(1 / sine2 - 1);
    float const y = glm::clamp(-cotangent_cap * cosine / sine_centre, -1.f, 1.f), chord = sine_centre * std::sqrt(1 - y * y);
    return glm::max(0.f, (cosine * std::acos(y) - cotangent_cap * chord) * sine2 + std::atan2(chord, cotangent_cap));
}

/// Directions uniform over a spherical triangle (Arvo, "Stratified sampling of spherical triangles", 1995).
class SphericalTriangle {
  public:
    SphericalTriangle(glm::vec3 a_, glm::vec3 b_, glm::vec3 c_) : a(glm::normalize(a_)), b(glm::normalize(b_)), c(glm::normalize(c_)) {
        auto const ab = glm::cross(a, b), bc = glm::cross(b, c), ca = glm::cross(c, a);
        alpha = angle(ab, -ca);
        solid_angle = alpha + angle(bc, -ab) + angle(ca, -bc) - pi;
    }

    [[nodiscard]] glm::vec3 direction(glm::vec2 random) const {
        float const part = random.x * solid_angle - alpha, s = std::sin(part), t = std::cos(part);
        float const cosine_alpha = std::cos(alpha), sine_alpha = std::sin(alpha);
        float const u = t - cosine_alpha, v = s + sine_alpha * glm::dot(a, b);
        float const q = glm::clamp(((v * t - u * s) * cosine_alpha - v) / ((v * s + u * t) * sine_alpha), -1.f, 1.f);
        auto const on_edge = q * a + std::sqrt(1 - q * q) * away(c, a);
        float const z = 1 - random.y * (1 - glm::dot(on_edge, b));
        return z * b + std::sqrt(glm::max(0.f, 1 - z * z)) * away(on_edge, b);
    }

    float solid_angle;

  private:
    static float angle(glm::vec3 x, glm::vec3 y) { return std::atan2(glm::length(glm::cross(x, y)), glm::dot(x, y)); }
    /// The unit direction of x seen from y, at right angles to y.
    static glm::vec3 away(glm::vec3 x, glm::vec3 y) {
        auto const part = x - glm::dot(x, y) * y;
        float const length2 = glm::dot(part, part);
        return length2 > 1e-20f ? part / std::sqrt(length2) : glm::vec3{0.f};
    }

    glm::vec3 a, b, c;
    float alpha;
};

struct Candidate {
    glm::vec3 offset; ///< from the receiver
    float weight;
};

/// Resampled importance sampling (Talbot et al. 2005) among the points of a rank-1 lattice that random numbers shift: well spread
/// candidates leave next to no bias. `choice` stays uniform for the next use as it is narrowed down.
template <class Propose>
glm::vec3 resampled(Propose const& propose, glm::vec2 random, float choice) {
    Candidate chosen{propose(random).offset, 0};
    float sum = 0;
    for (int i = 0; i < candidate_count; ++i) {
        float const j = static_cast<float>(i) / candidate_count;
        auto const candidate = propose(glm::fract(random + glm::vec2(j, 5 * j)));
        if (!(candidate.weight > 0)) continue;
        sum += candidate.weight;
        float const share = candidate.weight / sum;
        if (choice < share) chosen = candidate;
        choice = choice < share ? choice / share : (choice - share) / (1 - share);
    }
    return chosen.offset;
}

/// Below this solid angle rounding spoils Arvo's method, while weights of points uniform in area hardly vary.
constexpr float small_solid_angle = 0.01f;

glm::vec3 sample_triangle(glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 normal, glm::vec2 random, float choice) {
    SphericalTriangle const seen{a, b, c};
    auto const plane = glm::cross(b - a, c - a);
    auto const by_direction = [&](glm::vec2 uv) {
        auto const direction = seen.direction(uv);
        float const distance = glm::dot(a, plane) / glm::dot(direction, plane);
        return Candidate{direction * distance, std::isfinite(distance) && distance > 0 ? glm::dot(direction, normal) : 0.f};
    };
    auto const by_area = [&](glm::vec2 uv) {
        float const root = std::sqrt(uv.x);
        auto const offset = a * (1 - root) + b * (root * (1 - uv.y)) + c * (root * uv.y);
        float const distance2 = glm::dot(offset, offset);
        return Candidate{offset, glm::dot(offset, normal) * std::abs(glm::dot(offset, plane)) / (distance2 * distance2)};
    };
    if (seen.solid_angle > small_solid_angle) return resampled(by_direction, random, choice);
    return resampled(by_area, random, choice);
}

float triangle_irradiance(glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 normal) {
    return std::abs(edge_term(a, b, normal) + edge_term(b, c, normal) + edge_term(c, a, normal));
}

/// The visible part is a fan of triangles; one is chosen by its exact irradiance.
glm::vec3 sample_polygon(Polygon const& polygon, glm::vec3 normal, glm::vec2 random, float choice) {
    float sum = 0;
    int chosen = 1;
    for (int i = 1; i + 1 < polygon.count; ++i) {
        float const weight = triangle_irradiance(polygon[0], polygon[i], polygon[i + 1], normal);
        if (!(weight > 0)) continue;
        sum += weight;
        float const share = weight / sum;
        if (choice < share) chosen = i;
        choice = choice < share ? choice / share : (choice - share) / (1 - share);
    }
    return sample_triangle(polygon[0], polygon[chosen], polygon[chosen + 1], normal, random, choice);
}

glm::vec3 sample_sphere(Emitter const& emitter, glm::vec3 position, glm::vec3 normal, glm::vec2 random, float choice) {
    auto const offset = emitter.centre - position;
    float const distance = glm::length(offset), sine2 = glm::min(1.f, emitter.radius * emitter.radius / (distance * distance));
    auto const axis = offset / distance;
    Basis const basis{axis};
    float const cap = sine2 < 1e-4f ? sine2 / 2 : 1 - std::sqrt(1 - sine2);
    return resampled(
        [&](glm::vec2 uv) {
            float const below = uv.x * cap, cosine = 1 - below, sine = std::sqrt(below * (2 - below)), turn = 2 * pi * uv.y;
            auto const direction = basis.world({sine * std::cos(turn), sine * std::sin(turn), cosine});
            float const chord2 = emitter.radius * emitter.radius - distance * distance * sine * sine;
            return Candidate{direction * (distance * cosine - std::sqrt(glm::max(0.f, chord2))), glm::dot(direction, normal)};
        },
        random, choice);
}

} // namespace

glm::vec3 Emitter::before(glm::vec3 point) const {
    if (is_sphere()) return point + (centre_before - centre) + (turned_before * (point - centre) - (point - centre));
    // The point's coordinates along two edges stay what they are, whatever affine map the polygon went through.
    auto const u = corners[1] - corners[0], v = corners[2] - corners[0], offset = point - corners[0];
    float const uu = glm::dot(u, u), uv = glm::dot(u, v), vv = glm::dot(v, v), pu = glm::dot(offset, u), pv = glm::dot(offset, v);
    float const determinant = uu * vv - uv * uv;
    if (!(determinant > 0)) return point + (corners_before[0] - corners[0]);
    float const s = (pu * vv - pv * uv) / determinant, t = (pv * uu - pu * uv) / determinant;
    auto const shift0 = corners_before[0] - corners[0], shift1 = corners_before[1] - corners[1], shift2 = corners_before[2] - corners[2];
    return point + shift0 + s * (shift1 - shift0) + t * (shift2 - shift0);
}

float irradiance(Emitter const& emitter, glm::vec3 position, glm::vec3 normal) {
    return emitter.is_sphere() ? sphere_irradiance(emitter, position, normal) : polygon_irradiance(emitter, position, normal);
}

glm::vec3 sample_point(Emitter const& emitter, glm::vec3 position, glm::vec3 normal, glm::vec2 random, float choice) {
    if (emitter.is_sphere()) return position + sample_sphere(emitter, position, normal, random, choice);
    auto const polygon = above_horizon(emitter, position, normal);
    if (polygon.count < 3) return emitter.corners[0];
    return position + sample_polygon(polygon, normal, random, choice);
}

} // namespace quell::tracer
