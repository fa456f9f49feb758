#pragma once

#include "math.hpp"

namespace quell::tracer {

struct Ray {
    glm::vec3 origin{0.f}, direction{0.f, 0.f, -1.f}; ///< direction of unit length
    float far = infinity;
    float time = 0; ///< 0..1 over the open shutter
};

/// What a ray met first. `coordinates` locates the point on the shape itself, so that it can be found again at any other time:
/// barycentric on a triangle, the point on the unit sphere on a sphere.
struct Hit {
    int instance = -1;
    unsigned triangle = 0;
    glm::vec3 coordinates{0.f};
    float distance = infinity;

    explicit operator bool() const { return instance >= 0; }
};

/// Rays traced, by what they were for. Shadow rays of secondary hits count as shadow rays.
struct RayCounts {
    long long primary = 0, shadow = 0, glossy = 0, indirect = 0;

    RayCounts& operator+=(RayCounts const& other) {
        primary += other.primary;
        shadow += other.shadow;
        glossy += other.glossy;
        indirect += other.indirect;
        return *this;
    }
    friend bool operator==(RayCounts const&, RayCounts const&) = default;
};

} // namespace quell::tracer
