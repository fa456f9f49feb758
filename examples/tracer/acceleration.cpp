#include "acceleration.hpp"

#include <quell/core/error.hpp>

#include <cstring>
#include <string>

namespace quell::tracer {
namespace {

/// Geometry that belongs to one scene of its own, always under this number.
constexpr unsigned only_geometry = 0;

/// A surface is never met twice from the same point: origins are moved off their surface, so that rays can start at zero.
RTCRay embree_ray(Ray const& ray) {
    RTCRay result{};
    result.org_x = ray.origin.x, result.org_y = ray.origin.y, result.org_z = ray.origin.z;
    result.dir_x = ray.direction.x, result.dir_y = ray.direction.y, result.dir_z = ray.direction.z;
    result.tfar = ray.far;
    result.time = ray.time;
    result.mask = ~0u;
    return result;
}

void skip_holes(RTCFilterFunctionNArguments const* arguments) {
    auto const& test = *static_cast<AlphaTest const*>(arguments->geometryUserPtr);
    for (unsigned i = 0; i < arguments->N; ++i) {
        if (arguments->valid[i] == 0) continue;
        float const u = RTCHitN_u(arguments->hit, arguments->N, i), v = RTCHitN_v(arguments->hit, arguments->N, i);
        auto const& corners = test.mesh->triangles[RTCHitN_primID(arguments->hit, arguments->N, i)];
        auto const& uvs = test.mesh->uvs;
        auto const uv = uvs[corners.x] * (1 - u - v) + uvs[corners.y] * u + uvs[corners.z] * v;
        if (test.texture->at(uv, 0.f).a < test.cutoff) arguments->valid[i] = 0;
    }
}

void set_vertices(RTCGeometry geometry, std::vector<glm::vec3> const& positions, unsigned moment) {
    void* buffer =
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, moment, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), positions.size());
    if (buffer != nullptr) std::memcpy(buffer, positions.data(), positions.size() * sizeof(glm::vec3));
}

EmbreePointer<RTCGeometry> triangle_geometry(RTCDevice device, TriangleMesh const& mesh) {
    EmbreePointer<RTCGeometry> geometry{rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE)};
    set_vertices(geometry.get(), mesh.positions, 0);
    void* indices =
        rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(glm::uvec3), mesh.triangles.size());
    if (indices != nullptr) std::memcpy(indices, mesh.triangles.data(), mesh.triangles.size() * sizeof(glm::uvec3));
    return geometry;
}

EmbreePointer<RTCGeometry> sphere_geometry(RTCDevice device) {
    EmbreePointer<RTCGeometry> geometry{rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT)};
    auto* sphere =
        static_cast<float*>(rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, 4 * sizeof(float), 1));
    sphere[0] = sphere[1] = sphere[2] = 0;
    sphere[3] = 1;
    return geometry;
}

bool has_collapsed(glm::mat4 const& matrix) {
    float const volume = glm::determinant(glm::mat3(matrix));
    return !std::isfinite(volume) || std::abs(volume) < 1e-20f;
}

} // namespace

Acceleration::Acceleration(SceneDescription const& scene)
    : description(scene), device(rtcNewDevice(nullptr)), world(rtcNewScene(device.get())) {
    rtcSetSceneFlags(world.get(), RTC_SCENE_FLAG_ROBUST);
    for (auto const& instance : scene.instances) {
        auto& geometry = instances.emplace_back(rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_INSTANCE));
        rtcSetGeometryInstancedScene(geometry.get(), part_of(instance).scene.get());
        rtcAttachGeometryByID(world.get(), geometry.get(), static_cast<unsigned>(instances.size() - 1));
    }
    check();
}

Acceleration::Part& Acceleration::part_of(SceneInstance const& instance) {
    auto const& shape = description.shapes[static_cast<std::size_t>(instance.shape)];
    auto const& material = description.materials[static_cast<std::size_t>(instance.material)];
    bool const has_holes = material.alpha_cutoff > 0 && material.base_texture >= 0 && !shape.mesh.uvs.empty();
    std::pair const key{instance.shape, has_holes ? instance.material : -1};
    auto const found = parts.find(key);
    if (found != parts.end()) return found->second;
    auto part = build(shape);
    if (has_holes) add_alpha_test(part, shape, material);
    rtcCommitGeometry(part.geometry.get());
    rtcAttachGeometryByID(part.scene.get(), part.geometry.get(), only_geometry);
    rtcCommitScene(part.scene.get());
    return parts.emplace(key, std::move(part)).first->second;
}

Acceleration::Part Acceleration::build(Shape const& shape) const {
    Part part;
    part.scene.reset(rtcNewScene(device.get()));
    part.geometry = shape.is_sphere ? sphere_geometry(device.get()) : triangle_geometry(device.get(), shape.mesh);
    // Robust: otherwise rays slip through between neighbouring triangles, which shows as sparks of light.
    rtcSetSceneFlags(part.scene.get(), RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(part.scene.get(), shape.is_deforming() ? RTC_BUILD_QUALITY_MEDIUM : RTC_BUILD_QUALITY_HIGH);
    return part;
}

void Acceleration::add_alpha_test(Part& part, Shape const& shape, Material const& material) const {
    auto const& texture = description.textures[static_cast<std::size_t>(material.base_texture)];
    part.alpha_test = std::make_unique<AlphaTest>(AlphaTest{&shape.mesh, &texture, material.alpha_cutoff});
    rtcSetGeometryUserData(part.geometry.get(), part.alpha_test.get());
    rtcSetGeometryIntersectFilterFunction(part.geometry.get(), skip_holes);
    rtcSetGeometryOccludedFilterFunction(part.geometry.get(), skip_holes);
}

void Acceleration::deform(int shape, std::vector<TriangleMesh> const& moments) {
    for (auto& [key, part] : parts) {
        if (key.first != shape) continue;
        rtcSetGeometryTimeStepCount(part.geometry.get(), static_cast<unsigned>(moments.size()));
        for (std::size_t i = 0; i < moments.size(); ++i) set_vertices(part.geometry.get(), moments[i].positions, static_cast<unsigned>(i));
        rtcCommitGeometry(part.geometry.get());
        rtcCommitScene(part.scene.get());
    }
}

void Acceleration::place(int instance, std::vector<glm::mat4> const& moments) {
    auto* geometry = instances[static_cast<std::size_t>(instance)].get();
    rtcSetGeometryTimeStepCount(geometry, static_cast<unsigned>(moments.size()));
    bool collapsed = false;
    for (std::size_t i = 0; i < moments.size(); ++i) {
        rtcSetGeometryTransform(geometry, static_cast<unsigned>(i), RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR, &moments[i][0][0]);
        collapsed = collapsed || has_collapsed(moments[i]);
    }
    // What is scaled to nothing can't be seen, and its inverse would be full of NaN.
    collapsed ? rtcDisableGeometry(geometry) : rtcEnableGeometry(geometry);
    rtcCommitGeometry(geometry);
}

void Acceleration::commit() {
    rtcCommitScene(world.get());
    check();
}

void Acceleration::check() const {
    auto const code = rtcGetDeviceError(device.get());
    if (code == RTC_ERROR_NONE) return;
    throw Failure{"scene " + description.name, "Embree reports error " + std::to_string(static_cast<int>(code)),
                  "check its meshes' indices and the free memory"};
}

Hit Acceleration::intersect(Ray const& ray) const {
    RTCRayHit query{};
    query.ray = embree_ray(ray);
    query.hit.geomID = query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    embree_intersect(world.get(), query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
    return {
        static_cast<int>(query.hit.instID[0]), query.hit.primID, {1 - query.hit.u - query.hit.v, query.hit.u, query.hit.v}, query.ray.tfar};
}

bool Acceleration::occluded(Ray const& ray) const {
    auto query = embree_ray(ray);
    embree_occluded(world.get(), query);
    return query.tfar < 0;
}

} // namespace quell::tracer
