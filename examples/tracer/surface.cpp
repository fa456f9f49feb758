#include "surface.hpp"

namespace quell::tracer {
namespace {

/// Relative to coordinates and distances: a hundred times the rounding error of a hit in float.
constexpr float relative_clearance = 3e-5f;

struct Geometry {
    glm::vec3 position, face, shading; ///< normals still outwards, of any length
    glm::vec2 uv{0.f};
    float uv_per_length = 0;
};

glm::vec3 turned(glm::mat4 const& placement, glm::vec3 normal) { return glm::transpose(glm::inverse(glm::mat3(placement))) * normal; }

Geometry sphere_geometry(glm::mat4 const& placement, Hit const& hit) {
    Geometry found;
    auto const local = hit.coordinates;
    found.position = placement * glm::vec4(local, 1.f);
    found.face = found.shading = turned(placement, local);
    found.uv = {0.5f + std::atan2(local.x, local.z) / (2 * pi), std::acos(glm::clamp(local.y, -1.f, 1.f)) / pi};
    found.uv_per_length = 1 / (pi * glm::length(glm::vec3(placement[0])));
    return found;
}

template <class Value> Value interpolated(std::vector<Value> const& values, glm::uvec3 corners, glm::vec3 weights) {
    return values[corners.x] * weights.x + values[corners.y] * weights.y + values[corners.z] * weights.z;
}

/// Ratio of lengths in texture space to lengths in the world (Akenine-Moller et al., "Texture level of detail strategies for real-time
/// ray tracing", 2019).
float texture_density(std::vector<glm::vec2> const& uvs, glm::uvec3 corners, float twice_area) {
    auto const a = uvs[corners.y] - uvs[corners.x], b = uvs[corners.z] - uvs[corners.x];
    return twice_area > 0 ? std::sqrt(std::abs(a.x * b.y - a.y * b.x) / twice_area) : 0.f;
}

Geometry mesh_geometry(PreparedScene const& scene, glm::mat4 const& placement, Hit const& hit, float time) {
    auto const& mesh = scene.shape(hit.instance).mesh;
    auto const corners = mesh.triangles[hit.triangle];
    glm::vec3 local[3], point[3];
    for (int i = 0; i < 3; ++i) {
        local[i] = scene.corner(hit, i, time, When::now);
        point[i] = placement * glm::vec4(local[i], 1.f);
    }
    auto const weights = hit.coordinates;
    Geometry found;
    found.position = placement * glm::vec4(local[0] * weights.x + local[1] * weights.y + local[2] * weights.z, 1.f);
    found.face = glm::cross(point[1] - point[0], point[2] - point[0]);
    found.shading = found.face;
    if (!mesh.normals.empty()) {
        glm::vec3 sum{0.f};
        for (int i = 0; i < 3; ++i) sum += scene.corner_normal(hit, i, time) * weights[i];
        found.shading = turned(placement, sum);
    }
    if (!mesh.uvs.empty()) {
        found.uv = interpolated(mesh.uvs, corners, weights);
        found.uv_per_length = texture_density(mesh.uvs, corners, glm::length(found.face));
    }
    if (glm::determinant(glm::mat3(placement)) < 0) found.face = -found.face;
    return found;
}

glm::vec4 texel(PreparedScene const& scene, int texture, Geometry const& geometry, float width) {
    if (texture < 0) return glm::vec4{1.f};
    return scene.description().textures[static_cast<std::size_t>(texture)].at(geometry.uv, width * geometry.uv_per_length);
}

void apply_material(PreparedScene const& scene, Hit const& hit, Geometry const& geometry, float width, bool outside, Surface& surface) {
    auto const& material = scene.material(hit.instance);
    auto const roughness_metallic = texel(scene, material.metallic_roughness_texture, geometry, width);
    surface.base = material.base * glm::vec3(texel(scene, material.base_texture, geometry, width));
    surface.metallic = material.metallic * roughness_metallic.b;
    surface.roughness = material.roughness * roughness_metallic.g;
    surface.is_emitter = glm::length(material.emission) > 0;
    surface.is_light = scene.is_light(hit.instance);
    bool const shines = surface.is_emitter && (outside || material.emits_both_sides);
    if (shines)
        surface.emission =
            material.emission * scene.brightness(hit.instance) * glm::vec3(texel(scene, material.emission_texture, geometry, width));
}

/// Interpolated normals may point away from the viewer near a silhouette; they are bent back until they no longer do.
glm::vec3 facing(glm::vec3 shading, glm::vec3 face, glm::vec3 to_viewer) {
    if (glm::dot(shading, face) < 0) shading = -shading;
    float const cosine = glm::dot(shading, to_viewer), least = 0.01f;
    return cosine >= least ? shading : glm::normalize(shading + to_viewer * (least - cosine));
}

float largest(glm::vec3 v) { return glm::max(std::abs(v.x), glm::max(std::abs(v.y), std::abs(v.z))); }

} // namespace

glm::vec3 Surface::origin(glm::vec3 direction) const {
    return position + geometric_normal * (glm::dot(direction, geometric_normal) < 0 ? -clearance : clearance);
}

Surface surface_at(PreparedScene const& scene, Ray const& ray, Hit const& hit, float footprint_angle) {
    auto const placement = scene.placement(hit.instance, ray.time, When::now);
    bool const is_sphere = scene.shape(hit.instance).is_sphere;
    auto const geometry = is_sphere ? sphere_geometry(placement, hit) : mesh_geometry(scene, placement, hit, ray.time);
    auto const face = unit_or(geometry.face, -ray.direction);
    bool const outside = glm::dot(face, ray.direction) < 0;
    Surface surface;
    surface.position = geometry.position;
    surface.clearance = relative_clearance * (largest(geometry.position) + hit.distance);
    surface.geometric_normal = outside ? face : -face;
    surface.normal = facing(unit_or(geometry.shading, face), surface.geometric_normal, -ray.direction);
    apply_material(scene, hit, geometry, footprint_angle * hit.distance, outside, surface);
    return surface;
}

} // namespace quell::tracer
