#pragma once

#include "ray.hpp"
#include "scene.hpp"

#include <quell/image/extent.hpp>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace quell::tracer {

/// A camera at one moment, for rays and for projection. Pixels as everywhere in quell: (0, 0) is the top-left corner, y grows down.
class View {
public:
    View(CameraPose const& pose, Extent size);

    [[nodiscard]] glm::vec3 eye() const { return origin; }
    /// The ray through a place in the image, from a place on the lens: in the unit disk, of which (0, 0) is the eye.
    [[nodiscard]] Ray ray(glm::vec2 place, glm::vec2 on_lens, float time) const;
    /// Unit direction through a place in the image.
    [[nodiscard]] glm::vec3 direction(glm::vec2 place) const;
    /// Where a point (w = 1) or a direction (w = 0) appears; NaN behind the camera.
    [[nodiscard]] glm::vec2 project(glm::vec3 point, float w = 1) const;
    /// Distance along the view axis.
    [[nodiscard]] float depth(glm::vec3 point) const;
    /// How much direction one pixel covers, in radians.
    [[nodiscard]] float pixel_angle() const { return pixel; }

private:
    glm::vec3 origin, right, up, forward;
    glm::vec2 centre, pixels_per_slope; ///< image centre; pixels per unit of tangent
    float pixel;
    Lens lens;
};

} // namespace quell::tracer
