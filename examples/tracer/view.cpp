#include "view.hpp"

#include <glm/geometric.hpp>

#include <cmath>

namespace quell::tracer {

View::View(CameraPose const& pose, Extent size)
    : origin(pose.world_from_camera[3]), right(glm::normalize(glm::vec3(pose.world_from_camera[0]))),
      up(glm::normalize(glm::vec3(pose.world_from_camera[1]))), forward(-glm::normalize(glm::vec3(pose.world_from_camera[2]))) {
    float const half_height = static_cast<float>(size.height) / 2, slope = std::tan(pose.vertical_field_of_view / 2);
    centre = {static_cast<float>(size.width) / 2, half_height};
    pixels_per_slope = {half_height / slope, -half_height / slope};
    pixel = slope / half_height;
    lens = pose.lens;
}

Ray View::ray(glm::vec2 place, glm::vec2 on_lens, float time) const {
    if (!lens) return {origin, direction(place), infinity, time};
    auto const slope = (place - centre) / pixels_per_slope;
    auto const sharp = (forward + right * slope.x + up * slope.y) * lens.focus;
    auto const start = (right * on_lens.x + up * on_lens.y) * lens.radius;
    return {origin + start, glm::normalize(sharp - start), infinity, time};
}

glm::vec3 View::direction(glm::vec2 place) const {
    auto const slope = (place - centre) / pixels_per_slope;
    return glm::normalize(forward + right * slope.x + up * slope.y);
}

glm::vec2 View::project(glm::vec3 point, float w) const {
    auto const offset = point - w * origin;
    float const along = glm::dot(offset, forward);
    if (!(along > 0)) return glm::vec2{not_a_number};
    return centre + pixels_per_slope * glm::vec2(glm::dot(offset, right), glm::dot(offset, up)) / along;
}

float View::depth(glm::vec3 point) const { return glm::dot(point - origin, forward); }

} // namespace quell::tracer
