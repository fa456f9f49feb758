#include "emitter.hpp"
#include "polygon.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace quell::tracer {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

bool shows_its_dark_side(Emitter const& emitter, glm::vec3 position) {
    auto const normal = glm::cross(emitter.corners[1] - emitter.corners[0], emitter.corners[2] - emitter.corners[0]);
    return !emitter.both_sides && glm::dot(normal, position - emitter.corners[0]) <= 0;
}

float polygon_irradiance(Emitter const& emitter, glm::vec3 position, glm::vec3 normal) {
    if (shows_its_dark_side(emitter, position)) return 0;
    auto polygon = above_horizon({emitter.corners.data(), static_cast<std::size_t>(emitter.corner_count)}, position, normal);
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

} // namespace quell::tracer
