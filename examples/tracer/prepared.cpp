#include "prepared.hpp"

#include <quell/core/error.hpp>

#include <algorithm>

namespace quell::tracer {
namespace {

/// Unshadowed light sums over all lights at every hit. Finely tessellated emitters would make that slow; they only glow.
constexpr std::size_t max_light_triangles = 512;

glm::mat4 between(glm::mat4 const& a, glm::mat4 const& b, float part) { return a + (b - a) * part; }
glm::vec3 between(glm::vec3 a, glm::vec3 b, float part) { return a + (b - a) * part; }

/// A camera stays rigid on its way: its axes are made orthonormal again.
CameraPose between(CameraPose const& a, CameraPose const& b, float part) {
    Lens const lens{glm::mix(a.lens.radius, b.lens.radius, part), glm::mix(a.lens.focus, b.lens.focus, part)};
    if (a.world_from_camera == b.world_from_camera && a.vertical_field_of_view == b.vertical_field_of_view)
        return {a.world_from_camera, a.vertical_field_of_view, lens};
    auto matrix = between(a.world_from_camera, b.world_from_camera, part);
    glm::vec3 const back = glm::normalize(glm::vec3(matrix[2])), right{matrix[0]}, up{matrix[1]};
    auto const across = glm::normalize(right - glm::dot(right, back) * back);
    auto const upright = glm::normalize(up - glm::dot(up, back) * back - glm::dot(up, across) * across);
    matrix[0] = glm::vec4(across, 0.f), matrix[1] = glm::vec4(upright, 0.f), matrix[2] = glm::vec4(back, 0.f);
    return {matrix, glm::mix(a.vertical_field_of_view, b.vertical_field_of_view, part), lens};
}

/// Of a light its places.
Emitter between(Emitter a, Emitter const& b, float part) {
    for (std::size_t i = 0; i < a.corners.size(); ++i) {
        a.corners[i] = between(a.corners[i], b.corners[i], part);
        a.corners_before[i] = between(a.corners_before[i], b.corners_before[i], part);
    }
    a.centre = between(a.centre, b.centre, part);
    a.centre_before = between(a.centre_before, b.centre_before, part);
    return a;
}

/// Interpolates `value_at(i)` over evenly spaced moments.
template <class ValueAt> auto at_time(std::size_t count, float time, ValueAt const& value_at) {
    if (count == 1) return value_at(std::size_t{0});
    float const place = glm::clamp(time, 0.f, 1.f) * static_cast<float>(count - 1);
    auto const first = std::min(static_cast<std::size_t>(place), count - 2);
    return between(value_at(first), value_at(first + 1), place - static_cast<float>(first));
}

bool is_planar(std::vector<glm::vec3> const& positions, glm::uvec4 corners) {
    auto const a = positions[corners.x], b = positions[corners.y], c = positions[corners.z], d = positions[corners.w];
    auto const first = glm::cross(b - a, c - a), second = glm::cross(c - a, d - a);
    return glm::dot(first, second) > 0.99999f * glm::length(first) * glm::length(second);
}

bool is_convex(std::vector<glm::vec3> const& positions, glm::uvec4 corners) {
    auto const normal = glm::cross(positions[corners.y] - positions[corners.x], positions[corners.z] - positions[corners.x]);
    for (int i = 0; i < 4; ++i) {
        auto const a = positions[corners[i]], b = positions[corners[(i + 1) % 4]], c = positions[corners[(i + 2) % 4]];
        if (glm::dot(glm::cross(b - a, c - b), normal) <= 0) return false;
    }
    return true;
}

/// Two triangles in a row, (a b c) and (a c d), that make one flat convex quadrilateral.
bool is_quadrilateral(TriangleMesh const& mesh, std::size_t i) {
    if (i + 1 >= mesh.triangles.size()) return false;
    auto const first = mesh.triangles[i], second = mesh.triangles[i + 1];
    glm::uvec4 const corners{first, second.z};
    return first.x == second.x && first.z == second.y && is_planar(mesh.positions, corners) && is_convex(mesh.positions, corners);
}

/// A mirroring placement makes the order of corners clockwise.
void turn_over(Emitter& emitter) {
    std::reverse(emitter.corners.begin(), emitter.corners.begin() + emitter.corner_count);
    std::reverse(emitter.corners_before.begin(), emitter.corners_before.begin() + emitter.corner_count);
}

} // namespace

PreparedScene::PreparedScene(SceneDescription description_)
    : scene(std::move(description_)), acceleration(scene), placements(scene.instances.size()), deformations(scene.shapes.size()) {
    find_emitters();
    for (auto const& instance : scene.instances)
        partial_coverage = partial_coverage || scene.materials[static_cast<std::size_t>(instance.material)].coverage;
}

Shape const& PreparedScene::shape(int instance) const {
    return scene.shapes[static_cast<std::size_t>(scene.instances[static_cast<std::size_t>(instance)].shape)];
}

Material const& PreparedScene::material(int instance) const {
    return scene.materials[static_cast<std::size_t>(scene.instances[static_cast<std::size_t>(instance)].material)];
}

CameraPose PreparedScene::camera(float time, When when) const {
    auto const& moments = cameras.at(when);
    return at_time(moments.size(), time, [&](std::size_t i) { return moments[i]; });
}

std::vector<float> PreparedScene::moments_before(float earlier) const {
    if (!(current_shutter > 0)) return {current_frame - earlier};
    std::vector<float> frames;
    for (int i = 0; i < current_keys; ++i)
        frames.push_back(current_frame - earlier + current_shutter * static_cast<float>(i) / static_cast<float>(current_keys - 1));
    return frames;
}

/// A function of time at the moments of the open shutter, and one frame earlier.
auto PreparedScene::at_moments(auto const& value_at) const {
    Moments<decltype(value_at(0.f))> moments;
    for (float at : moments_before(0)) moments.now.push_back(value_at(at));
    for (float at : moments_before(1)) moments.before.push_back(value_at(at));
    return moments;
}

void PreparedScene::move_to(float frame, float shutter, int keys) {
    if (frame == current_frame && shutter == current_shutter && keys == current_keys) return;
    current_frame = frame;
    current_shutter = shutter;
    current_keys = keys;
    cameras = at_moments([&](float at) { return usable_camera(at); });
    place_instances();
    deform_shapes();
    acceleration.commit();
    light_up();
}

PreparedScene const& PreparedScene::one_frame_earlier() {
    if (!earlier) earlier = std::make_unique<PreparedScene>(scene);
    earlier->move_to(current_frame - 1, current_shutter, current_keys);
    return *earlier;
}

/// Embree aborts the program for a ray that isn't finite.
CameraPose PreparedScene::usable_camera(float frame) const {
    auto const pose = scene.camera(frame);
    if (pose.is_usable()) return pose;
    throw Error("scene '" + scene.name + "'",
                "its camera at frame " + std::to_string(frame) + " is scaled to nothing, not finite, or far off",
                "mend the camera's animation, or give --eye, --target and --fov");
}

void PreparedScene::place_instances() {
    for (std::size_t i = 0; i < placements.size(); ++i) {
        placements[i] = at_moments([&](float at) { return scene.node_matrix(scene.instances[i].node, at); });
        acceleration.place(static_cast<int>(i), placements[i].now);
    }
}

void PreparedScene::deform_shapes() {
    for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
        if (!scene.shapes[i].is_deforming()) continue;
        deformations[i] = at_moments([&](float at) { return scene.vertices_at(scene.shapes[i], at); });
        acceleration.deform(static_cast<int>(i), deformations[i].now);
    }
}

Hit PreparedScene::first_hit(Ray const& ray, float met) const {
    return nearest_of(ray, [&](Coverage const& coverage) {
        bool const meets = met < coverage.part;
        met = meets ? met / coverage.part : (met - coverage.part) / (1 - coverage.part); // a number in [0, 1) again, for the next one
        return meets;
    });
}

Hit PreparedScene::intersect(Ray const& ray) const {
    return nearest_of(ray, [](Coverage const& coverage) { return !coverage; });
}

bool PreparedScene::occluded(Ray const& ray) const {
    if (!partial_coverage) return acceleration.occluded(ray);
    return static_cast<bool>(intersect(ray));
}

Hit PreparedScene::nearest_of(Ray ray, auto const& meets) const {
    float passed = 0; // from where the ray began
    auto hit = located(ray);
    while (hit && material(hit.instance).coverage && !meets(material(hit.instance).coverage)) {
        float const step = hit.distance + 1e-4f * (1 + hit.distance);
        ray.origin += ray.direction * step;
        ray.far -= step;
        passed += step;
        hit = ray.far > 0 ? located(ray) : Hit{};
    }
    if (hit) hit.distance += passed;
    return hit;
}

Hit PreparedScene::located(Ray const& ray) const {
    auto hit = acceleration.intersect(ray);
    if (hit && shape(hit.instance).is_sphere) {
        auto const inverse = glm::inverse(placement(hit.instance, ray.time, When::now));
        hit.coordinates = glm::normalize(glm::vec3(inverse * glm::vec4(ray.origin + ray.direction * hit.distance, 1.f)));
    }
    return hit;
}

glm::mat4 PreparedScene::placement(int instance, float time, When when) const {
    auto const& moments = placements[static_cast<std::size_t>(instance)].at(when);
    return at_time(moments.size(), time, [&](std::size_t i) { return moments[i]; });
}

glm::vec3 PreparedScene::local_vertex(int instance, unsigned vertex, float time, When when) const {
    auto const shape_index = static_cast<std::size_t>(scene.instances[static_cast<std::size_t>(instance)].shape);
    auto const& moments = deformations[shape_index].at(when);
    if (moments.empty()) return scene.shapes[shape_index].mesh.positions[vertex];
    return at_time(moments.size(), time, [&](std::size_t i) { return moments[i].positions[vertex]; });
}

glm::vec3 PreparedScene::corner(Hit const& hit, int i, float time, When when) const {
    return local_vertex(hit.instance, shape(hit.instance).mesh.triangles[hit.triangle][i], time, when);
}

glm::vec3 PreparedScene::corner_normal(Hit const& hit, int i, float time) const {
    auto const shape_index = static_cast<std::size_t>(scene.instances[static_cast<std::size_t>(hit.instance)].shape);
    auto const& mesh = scene.shapes[shape_index].mesh;
    auto const vertex = mesh.triangles[hit.triangle][i];
    auto const& moments = deformations[shape_index].now;
    if (moments.empty()) return mesh.normals[vertex];
    return at_time(moments.size(), time, [&](std::size_t j) { return moments[j].normals[vertex]; });
}

glm::vec3 PreparedScene::point(Hit const& hit, float time, When when) const {
    glm::vec3 local = hit.coordinates;
    if (!shape(hit.instance).is_sphere) {
        local = glm::vec3{0.f};
        for (int i = 0; i < 3; ++i) local += corner(hit, i, time, when) * hit.coordinates[i];
    }
    return placement(hit.instance, time, when) * glm::vec4(local, 1.f);
}

void PreparedScene::find_emitters() {
    lights.assign(scene.instances.size(), false);
    for (int i = 0; i < static_cast<int>(scene.instances.size()); ++i) {
        if (!(glm::length(material(i).emission) > 0) || shape(i).mesh.triangles.size() > max_light_triangles) continue;
        lights[static_cast<std::size_t>(i)] = true;
        if (shape(i).is_sphere)
            sources.push_back({i, 0, {}, material(i).emission});
        else
            find_emitters_of(i);
    }
}

void PreparedScene::find_emitters_of(int instance) {
    auto const& mesh = shape(instance).mesh;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        bool const four = is_quadrilateral(mesh, i);
        glm::uvec4 const corners{mesh.triangles[i], four ? mesh.triangles[i + 1].z : 0u};
        int const count = four ? 4 : 3;
        sources.push_back({instance, count, corners, material(instance).emission * mean_emission_texel(instance, count, corners)});
        if (four) ++i;
    }
}

/// Lights shine evenly, as their formulas ask for: with the mean of the texels that they cover.
glm::vec3 PreparedScene::mean_emission_texel(int instance, int count, glm::uvec4 corners) const {
    auto const& uvs = shape(instance).mesh.uvs;
    int const texture = material(instance).emission_texture;
    if (texture < 0 || uvs.empty()) return glm::vec3{1.f};
    glm::vec2 sum{0.f}, least{infinity}, most{-infinity};
    for (int i = 0; i < count; ++i) {
        auto const uv = uvs[corners[i]];
        sum += uv, least = glm::min(least, uv), most = glm::max(most, uv);
    }
    auto const extent = most - least;
    return scene.textures[static_cast<std::size_t>(texture)].at(sum / static_cast<float>(count), glm::max(extent.x, extent.y));
}

void PreparedScene::light_up() {
    brightnesses.clear();
    for (int i = 0; i < static_cast<int>(scene.instances.size()); ++i)
        brightnesses.push_back(material(i).brightness ? material(i).brightness(current_frame) : 1.f);
    auto const count = moments_before(0).size();
    emitters.assign(count, {});
    for (std::size_t i = 0; i < count; ++i)
        for (auto const& source : sources)
            emitters[i].push_back(emitter_at(source, count > 1 ? static_cast<float>(i) / static_cast<float>(count - 1) : 0.f));
}

Emitter PreparedScene::emitter_at(EmitterSource const& source, float time) const {
    auto const now = placement(source.instance, time, When::now), before = placement(source.instance, time, When::before);
    Emitter emitter;
    emitter.radiance = source.radiance * brightness(source.instance);
    emitter.corner_count = source.corner_count;
    emitter.both_sides = material(source.instance).emits_both_sides;
    for (int i = 0; i < source.corner_count; ++i) {
        auto const corner = static_cast<std::size_t>(i);
        emitter.corners[corner] = now * glm::vec4(local_vertex(source.instance, source.vertices[i], time, When::now), 1.f);
        emitter.corners_before[corner] = before * glm::vec4(local_vertex(source.instance, source.vertices[i], time, When::before), 1.f);
    }
    if (glm::determinant(glm::mat3(now)) < 0) turn_over(emitter);
    emitter.centre = now[3];
    emitter.centre_before = before[3];
    emitter.radius = glm::length(glm::vec3(now[0]));
    if (now != before) emitter.turned_before = glm::mat3(before) * glm::inverse(glm::mat3(now));
    return emitter;
}

Emitter PreparedScene::emitter(std::size_t index, float time) const {
    return at_time(emitters.size(), time, [&](std::size_t i) -> Emitter const& { return emitters[i][index]; });
}

glm::vec3 PreparedScene::emitter_point(std::size_t index, glm::vec3 position, float time, float other) const {
    int const instance = sources[index].instance;
    auto const at_first = placement(instance, time, When::now), at_other = placement(instance, other, When::now);
    auto const there = emitter(index, other);
    auto moving = emitter(index, time);
    moving.corners_before = there.corners;
    moving.centre_before = there.centre;
    moving.turned_before = at_first == at_other ? glm::mat3{1.f} : glm::mat3(at_other) * glm::inverse(glm::mat3(at_first));
    return moving.before(position);
}

} // namespace quell::tracer
