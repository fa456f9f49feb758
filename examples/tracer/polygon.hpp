#pragma once

#include "math.hpp"

#include <array>
#include <span>

namespace quell::tracer {

/// The corners, as seen from a receiver at the origin, of the part of a convex polygon that is above the horizon.
struct SeenPolygon {
    std::array<glm::vec3, 5> corners{};
    int count = 0;
    void push(glm::vec3 corner) { corners[static_cast<std::size_t>(count++)] = corner; }
    [[nodiscard]] glm::vec3 operator[](int i) const { return corners[static_cast<std::size_t>(i)]; }
    [[nodiscard]] glm::vec3& operator[](int i) { return corners[static_cast<std::size_t>(i)]; }
};

/// Clips against the plane of the horizon (Sutherland and Hodgman 1974).
inline SeenPolygon above_horizon(std::span<glm::vec3 const> corners, glm::vec3 position, glm::vec3 normal) {
    SeenPolygon clipped;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        auto const a = corners[i] - position, b = corners[(i + 1) % corners.size()] - position;
        float const above_a = glm::dot(a, normal), above_b = glm::dot(b, normal);
        if (above_a >= 0) clipped.push(a);
        if ((above_a >= 0) != (above_b >= 0)) clipped.push(a + (b - a) * (above_a / (above_a - above_b)));
    }
    return clipped;
}

/// An angle from 0 to pi over its sine, given its cosine; relative error below 1e-7. It is smooth where acos is not, at cosine 1, so it
/// loses no digits for small angles. The polynomial interpolates acos(x) / sqrt(1 - x^2) at Chebyshev nodes in 0 <= x <= 1.
inline float angle_over_sine(float cosine) {
    constexpr std::array c{1.20919958f,     -0.263599395f,   0.0697329547f,    -0.0198470246f, 0.00586476892f,
                           -0.00173809834f, 0.000533703856f, -0.000213553343f, 6.71303485e-05f};
    float const t = 2 * std::abs(cosine) - 1;
    float sum = c[8];
    for (std::size_t i = 8; i > 0; --i) sum = sum * t + c[i - 1];
    if (cosine >= 0) return sum;
    return pi / std::sqrt(std::fmax(1 - cosine * cosine, 1e-12f)) - sum;
}

/// One edge's part of Lambert's formula, for unit vectors to its ends: the angle that it subtends times the cosine of its plane.
inline float edge_term(glm::vec3 a, glm::vec3 b, glm::vec3 normal) {
    return angle_over_sine(glm::dot(a, b)) * glm::dot(glm::cross(a, b), normal);
}

} // namespace quell::tracer
