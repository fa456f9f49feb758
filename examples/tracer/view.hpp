#pragma once

#include "ray.hpp"
#include "scene.hpp"

#include <quell/image/extent.hpp>

namespace quell::tracer {

/// A camera at one moment, for rays and for projection. Pixels as everywhere in quell: (0, 0) is the top-left corner, y grows down.
class View {
public:
    View(CameraPose const& pose, Extent size)
        : origin(pose.world_from_camera[3]), right(glm::normalize(glm::vec3(pose.world_from_camera[0]))),
          up(glm::normalize(glm::vec3(pose.world_from_camera[1]))), forward(-glm::normalize(glm::vec3(pose.world_from_camera[2]))),
          lens(pose.lens) {
        float const half_height = static_cast<float>(size.height) / 2, slope = std::tan(pose.vertical_field_of_view / 2);
        centre = {static_cast<float>(size.width) / 2, half_height};
        pixels_per_slope = {half_height / slope, -half_height / slope};
        pixel = slope / half_height;
    }

    [[nodiscard]] glm::vec3 eye() const { return origin; }
    /// The ray through a place in the image, from a place on the lens: in the unit disk, of which (0, 0) is the eye.
    [[nodiscard]] Ray ray(glm::vec2 place, glm::vec2 on_lens, float time) const {
        if (!lens) return {origin, direction(place), infinity, time};
        auto const sharp = towards(place) * lens.focus;
        auto const start = (right * on_lens.x + up * on_lens.y) * lens.radius;
        return {origin + start, glm::normalize(sharp - start), infinity, time};
    }
    /// Unit direction through a place in the image.
    [[nodiscard]] glm::vec3 direction(glm::vec2 place) const { return glm::normalize(towards(place)); }
    /// Where a point (w = 1) or a direction (w = 0) appears; NaN behind the camera.
    [[nodiscard]] glm::vec2 project(glm::vec3 point, float w = 1) const {
        auto const offset = point - w * origin;
        float const along = glm::dot(offset, forward);
        if (!(along > 0)) return glm::vec2{not_a_number};
        return centre + pixels_per_slope * glm::vec2(glm::dot(offset, right), glm::dot(offset, up)) / along;
    }
    /// Distance along the view axis.
    [[nodiscard]] float depth(glm::vec3 point) const { return glm::dot(point - origin, forward); }
    /// How much direction one pixel covers, in radians.
    [[nodiscard]] float pixel_angle() const { return pixel; }

private:
    [[nodiscard]] glm::vec3 towards(glm::vec2 place) const {
        auto const slope = (place - centre) / pixels_per_slope;
        return forward + right * slope.x + up * slope.y;
    }

    glm::vec3 origin, right, up, forward;
    glm::vec2 centre, pixels_per_slope; ///< image centre; pixels per unit of tangent
    float pixel;
    Lens lens;
};

} // namespace quell::tracer
