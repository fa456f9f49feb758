#include "emitter.hpp"
#include "polygon.hpp"

#include <span>

namespace quell::tracer {
namespace {

std::span<glm::vec3 const> corners_of(Emitter const& emitter) {
    return {emitter.corners.data(), static_cast<std::size_t>(emitter.corner_count)};
}

bool shows_its_dark_side(Emitter const& emitter, glm::vec3 position) {
    auto const normal = glm::cross(emitter.corners[1] - emitter.corners[0], emitter.corners[2] - emitter.corners[0]);
    return !emitter.both_sides && glm::dot(normal, position - emitter.corners[0]) <= 0;
}

float polygon_irradiance(Emitter const& emitter, glm::vec3 position, glm::vec3 normal) {
    if (shows_its_dark_side(emitter, position)) return 0;
    auto polygon = above_horizon(corners_of(emitter), position, normal);
    for (int i = 0; i < polygon.count; ++i) polygon[i] = glm::normalize(polygon[i]);
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

/// Directions uniform over a spherical triangle with these unit vectors as corners (Arvo, "Stratified sampling of spherical triangles",
/// 1995; its solid angle by Van Oosterom and Strackee, 1983).
class SphericalTriangle {
public:
    SphericalTriangle(glm::vec3 a_, glm::vec3 b_, glm::vec3 c_)
        : a(a_), b(b_), c(c_), towards_c(away(c_, a_)), cosine_ab(glm::dot(a_, b_)) {
        auto const ab = glm::cross(a, b), ac = glm::cross(a, c);
        float const volume = std::abs(glm::dot(ab, c));
        solid_angle = 2 * std::atan2(volume, 1 + cosine_ab + glm::dot(b, c) + glm::dot(c, a));
        alpha = std::atan2(volume, glm::dot(ab, ac));
        float const scale = 1 / std::sqrt(glm::dot(ab, ab) * glm::dot(ac, ac));
        sine_alpha = volume * scale, cosine_alpha = glm::dot(ab, ac) * scale;
    }

    [[nodiscard]] glm::vec3 direction(glm::vec2 random) const {
        float const part = random.x * solid_angle - alpha, s = std::sin(part), t = std::cos(part);
        float const u = t - cosine_alpha, v = s + sine_alpha * cosine_ab;
        float const q = glm::clamp(((v * t - u * s) * cosine_alpha - v) / ((v * s + u * t) * sine_alpha), -1.f, 1.f);
        auto const on_edge = q * a + std::sqrt(1 - q * q) * towards_c;
        float const z = 1 - random.y * (1 - glm::dot(on_edge, b));
        return z * b + std::sqrt(glm::max(0.f, 1 - z * z)) * away(on_edge, b);
    }

    /// No direction in the triangle has a larger cosine than this.
    [[nodiscard]] float cosine_bound(glm::vec3 normal) const {
        // A direction is a mean of the corners made longer, the more so the farther the flat triangle dips into the sphere.
        auto const plane = glm::cross(b - a, c - a);
        float const depth = std::abs(glm::dot(plane, a)) / glm::length(plane);
        return glm::min(1.f, glm::max(glm::dot(a, normal), glm::max(glm::dot(b, normal), glm::dot(c, normal))) / depth);
    }

    float solid_angle;

private:
    /// The unit direction of x seen from y, at right angles to y.
    static glm::vec3 away(glm::vec3 x, glm::vec3 y) {
        auto const part = x - glm::dot(x, y) * y;
        float const length2 = glm::dot(part, part);
        return length2 > 1e-20f ? part / std::sqrt(length2) : glm::vec3{0.f};
    }

    glm::vec3 a, b, c, towards_c;
    float alpha, cosine_alpha, sine_alpha, cosine_ab;
};

struct Candidate {
    glm::vec3 offset; ///< from the receiver
    float weight;
};

/// One of the points of a rank-1 lattice that random numbers shift, by resampled importance sampling (Talbot et al. 2005). Candidates that
/// are spread so well leave next to no bias.
template <class Propose> glm::vec3 resampled(Propose const& propose, glm::vec2 random, float choice) {
    constexpr int count = 8;
    Candidate chosen{glm::vec3{0.f}, 0};
    float sum = 0;
    for (int i = 0; i < count; ++i) {
        float const j = static_cast<float>(i) / count;
        auto const candidate = propose(glm::fract(random + glm::vec2(j, 5 * j)));
        if (i == 0) chosen.offset = candidate.offset;
        if (!(candidate.weight > 0)) continue;
        sum += candidate.weight;
        float const share = candidate.weight / sum;
        if (choice < share) chosen = candidate;
        choice = choice < share ? choice / share : (choice - share) / (1 - share);
    }
    return chosen.offset;
}

/// A point distributed as its weight, of which `bound` is the largest. The first proposal is nearly always taken where weights hardly
/// differ, so that well distributed random numbers give well distributed points; rejected, it's replaced by resampling. Both together are
/// exact: taken points have density w / bound, and the rest, 1 - mean / bound, is again distributed as w / mean.
template <class Propose> glm::vec3 weighted(Propose const& propose, float bound, glm::vec2 random, float choice) {
    auto const first = propose(random);
    float const taken = glm::clamp(first.weight / bound, 0.f, 1.f);
    if (choice < taken) return first.offset;
    return resampled(propose, random, taken < 1 ? (choice - taken) / (1 - taken) : choice);
}

/// Below this solid angle rounding spoils Arvo's method, while weights of points uniform in area hardly vary.
constexpr float small_solid_angle = 0.01f;

glm::vec3 sample_triangle(glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 normal, glm::vec2 random, float choice) {
    SphericalTriangle const seen{glm::normalize(a), glm::normalize(b), glm::normalize(c)};
    auto const plane = glm::cross(b - a, c - a);
    auto const by_direction = [&](glm::vec2 uv) {
        auto const direction = seen.direction(uv);
        float const distance = glm::dot(a, plane) / glm::dot(direction, plane);
        return Candidate{direction * distance, std::isfinite(distance) && distance > 0 ? glm::dot(direction, normal) : 0.f};
    };
    // The cosine at the light over the squared distance; the plane's distance, which is the same for all points, is left out.
    auto const weight_at = [&](glm::vec3 offset) {
        float const distance2 = glm::dot(offset, offset);
        return glm::dot(offset, normal) / (distance2 * distance2);
    };
    auto const by_area = [&](glm::vec2 uv) {
        float const root = std::sqrt(uv.x);
        auto const offset = a * (1 - root) + b * (root * (1 - uv.y)) + c * (root * uv.y);
        return Candidate{offset, weight_at(offset)};
    };
    if (seen.solid_angle > small_solid_angle) return weighted(by_direction, seen.cosine_bound(normal), random, choice);
    return weighted(by_area, glm::max(weight_at(a), glm::max(weight_at(b), weight_at(c))), random, choice);
}

/// The visible part is a fan of triangles; one is chosen by its exact irradiance.
glm::vec3 sample_polygon(SeenPolygon const& polygon, glm::vec3 normal, glm::vec2 random, float choice) {
    auto unit = polygon;
    for (int i = 0; i < unit.count; ++i) unit[i] = glm::normalize(unit[i]);
    std::array<float, 3> weights{};
    auto const count = static_cast<std::size_t>(polygon.count - 2);
    for (std::size_t i = 0; i < count; ++i) {
        auto const first = unit[0], second = unit[static_cast<int>(i) + 1], third = unit[static_cast<int>(i) + 2];
        weights[i] = std::abs(edge_term(first, second, normal) + edge_term(second, third, normal) + edge_term(third, first, normal));
    }
    int const chosen = static_cast<int>(choose(std::span{weights}.first(count), random.x)) + 1;
    return sample_triangle(polygon[0], polygon[chosen], polygon[chosen + 1], normal, random, choice);
}

glm::vec3 sample_sphere(Emitter const& emitter, glm::vec3 position, glm::vec3 normal, glm::vec2 random, float choice) {
    auto const offset = emitter.centre - position;
    float const distance = glm::length(offset), sine2 = glm::min(1.f, emitter.radius * emitter.radius / (distance * distance));
    auto const axis = offset / distance;
    Basis const basis{axis};
    float const cap = sine2 < 1e-4f ? sine2 / 2 : 1 - std::sqrt(1 - sine2);
    float const cosine = glm::dot(axis, normal), sine = std::sqrt(glm::max(0.f, 1 - cosine * cosine));
    bool const normal_inside = cosine > 1 - cap;
    float const bound = normal_inside ? 1.f : cosine * (1 - cap) + sine * std::sqrt(sine2);
    auto const propose = [&](glm::vec2 uv) {
        float const below = uv.x * cap, z = 1 - below, radius = std::sqrt(below * (2 - below)), turn = 2 * pi * uv.y;
        auto const direction = basis.world({radius * std::cos(turn), radius * std::sin(turn), z});
        float const chord2 = emitter.radius * emitter.radius - distance * distance * radius * radius;
        return Candidate{direction * (distance * z - std::sqrt(glm::max(0.f, chord2))), glm::dot(direction, normal)};
    };
    return weighted(propose, bound, random, choice);
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

std::size_t choose(std::span<float const> weights, float& random) {
    float sum = 0;
    for (float weight : weights) sum += weight;
    float before = 0;
    std::size_t last = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        if (!(weights[i] > 0)) continue;
        last = i;
        if (random * sum < before + weights[i]) break;
        before += weights[i];
    }
    if (weights[last] > 0) random = glm::clamp((random * sum - before) / weights[last], 0.f, 1 - 0x1p-24f);
    return last;
}

glm::vec3 sample_point(Emitter const& emitter, glm::vec3 position, glm::vec3 normal, glm::vec2 random, float choice) {
    if (emitter.is_sphere()) return position + sample_sphere(emitter, position, normal, random, choice);
    auto const polygon = above_horizon(corners_of(emitter), position, normal);
    if (polygon.count < 3) return emitter.corners[0];
    return position + sample_polygon(polygon, normal, random, choice);
}

} // namespace quell::tracer
