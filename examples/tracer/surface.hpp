#pragma once

#include "prepared.hpp"

namespace quell::tracer {

/// What a ray met, ready for shading. Both normals are in world space, of unit length, and face the side that the ray came from.
struct Surface {
    glm::vec3 position{not_a_number};
    glm::vec3 geometric_normal{0, 0, 1}, normal{0, 0, 1};
    glm::vec3 base{0.f}, emission{0.f};
    float metallic = 0, roughness = 1;
    float clearance = 0;     ///< how far new rays have to start off the surface so as not to meet it again
    bool is_emitter = false; ///< emits only, and reflects nothing
    bool is_light = false;   ///< an emitter that `direct` light accounts for

    [[nodiscard]] glm::vec3 diffuse() const { return base * (1 - metallic); }
    /// Where a ray into this direction starts.
    [[nodiscard]] glm::vec3 origin(glm::vec3 direction) const;
};

/// `footprint_angle`: how wide the ray's cone is in radians, for choosing a texture's mip level.
[[nodiscard]] Surface surface_at(PreparedScene const& scene, Ray const& ray, Hit const& hit, float footprint_angle);

} // namespace quell::tracer
