#pragma once

#include <quell/image/extent.hpp>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace quell::gauntlet {

using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;

/// What the lens does.
struct Lens {
    double width = 1.; ///< half of what it sees across, at a distance of 1
    Vec2 shift{0.};    ///< of the picture, in halves of its width
};

/// A pinhole camera.
struct View {
    Vec3 eye{0.}, right{1, 0, 0}, up{0, 1, 0}, forward{0, 0, -1};
    Lens lens{};
    Extent size{96, 54};

    /// Towards a place in pixels from the upper left corner. Its part along the view's axis is 1.
    [[nodiscard]] Vec3 direction(Vec2 place) const {
        auto const at = (place - middle()) / scale();
        return forward + right * (at.x + lens.shift.x * lens.width) - up * (at.y + lens.shift.y * lens.width);
    }
    /// Where a point is seen. Behind the eye that is no place of the picture.
    [[nodiscard]] Vec2 place_of(Vec3 point) const { return place_along(point - eye); }
    /// Where a direction is seen.
    [[nodiscard]] Vec2 place_along(Vec3 way) const {
        double const z = glm::dot(way, forward);
        Vec2 const at{glm::dot(way, right) / z - lens.shift.x * lens.width, -glm::dot(way, up) / z - lens.shift.y * lens.width};
        return middle() + at * scale();
    }

private:
    [[nodiscard]] Vec2 middle() const { return {size.width / 2., size.height / 2.}; }
    [[nodiscard]] double scale() const { return size.width / (2. * lens.width); }
};

/// A view from one point towards another.
inline View view_towards(Vec3 eye, Vec3 target, Lens lens, Extent size) {
    auto const forward = glm::normalize(target - eye), right = glm::normalize(glm::cross(forward, Vec3(0, 1, 0)));
    return {eye, right, glm::cross(right, forward), forward, lens, size};
}

} // namespace quell::gauntlet
