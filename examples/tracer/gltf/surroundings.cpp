#include "gltf.hpp"
#include "parts.hpp"

#include "../bounds.hpp"
#include "../shapes.hpp"

#include <quell/core/error.hpp>

#include <algorithm>

namespace quell::tracer {
namespace {

constexpr float default_field_of_view = 45;

/// Far enough away in a direction for all corners of the box to be seen, with a little room around them.
glm::vec3 framing_eye(Bounds const& bounds, glm::vec3 direction, float field_of_view) {
    auto const right = glm::normalize(glm::cross(glm::vec3{0, 1, 0}, direction)), up = glm::cross(direction, right);
    float const slope = std::tan(glm::radians(field_of_view) / 2) * 0.9f;
    float distance = 0;
    for (int i = 0; i < 8; ++i) {
        glm::vec3 const corner{i & 1 ? bounds.least.x : bounds.most.x, i & 2 ? bounds.least.y : bounds.most.y,
                               i & 4 ? bounds.least.z : bounds.most.z};
        auto const offset = corner - bounds.centre();
        // Images are taken to be half as wide again as they are high, at least.
        float const half_size = std::max(std::abs(glm::dot(offset, up)), std::abs(glm::dot(offset, right)) / 1.5f);
        distance = std::max(distance, half_size / slope + glm::dot(offset, direction));
    }
    return bounds.centre() + direction * distance;
}

glm::vec3 turned(glm::vec3 eye, glm::vec3 target, float degrees) {
    return target + glm::angleAxis(glm::radians(degrees), glm::vec3{0, 1, 0}) * (eye - target);
}

bool is_finite(glm::vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

std::string text_of(glm::vec3 v) { return std::to_string(v.x) + "," + std::to_string(v.y) + "," + std::to_string(v.z); }

void check(CameraChoice const& choice) {
    for (auto const& [option, place] :
         {std::pair{"--eye", choice.eye}, {"--target", choice.target}, {"--dolly", std::optional{choice.dolly}}})
        if (place && !is_finite(*place)) throw Error(option, text_of(*place), "give three finite numbers, as in 0,1.5,4");
    if (!std::isfinite(choice.orbit)) throw Error("--orbit", std::to_string(choice.orbit), "give degrees per frame");
    if (choice.field_of_view && !(*choice.field_of_view > 0 && *choice.field_of_view < 180))
        throw Error("--fov", std::to_string(*choice.field_of_view), "give degrees, more than 0 and less than 180");
}

} // namespace

void choose_camera(SceneDescription& scene, CameraChoice const& choice) {
    if (choice.is_default()) return;
    check(choice);
    auto const start = scene.camera(0);
    auto const bounds = bounds_of(scene, 0);
    float const field_of_view = choice.field_of_view.value_or(glm::degrees(start.vertical_field_of_view));
    glm::vec3 const own_eye{start.world_from_camera[3]}, forward{-start.world_from_camera[2]};
    auto const eye = choice.eye.value_or(own_eye);
    // The scene's own camera looks at whatever is as far along its axis as the middle of the scene.
    auto const ahead = own_eye + glm::normalize(forward) * std::max(glm::distance(own_eye, bounds.centre()), 1e-3f);
    auto const target = choice.target.value_or(choice.eye ? bounds.centre() : ahead);
    if (eye == target) throw Error("--eye", text_of(eye) + " is also what the camera looks at", "give another --eye or --target");
    if (!look_at(eye, target, field_of_view).is_usable())
        throw Error("scene '" + scene.name + "'", "no camera looks from " + text_of(eye) + " at " + text_of(target),
                    "give another --eye and --target");
    scene.camera = [=](float frame) {
        return look_at(turned(eye, target, choice.orbit * frame) + choice.dolly * frame, target + choice.dolly * frame, field_of_view);
    };
}

namespace gltf {
namespace {

/// The first node with a perspective camera, if any.
int camera_node(Model const& model) {
    auto const& nodes = model.content.nodes;
    auto const found = std::ranges::find_if(nodes, [&](tinygltf::Node const& node) {
        return node.camera >= 0 && model.item(model.content.cameras, node.camera, "camera").type == "perspective";
    });
    return found == nodes.end() ? -1 : static_cast<int>(found - nodes.begin());
}

} // namespace

void add_camera(Model const& model, SceneDescription& scene) {
    int const node = camera_node(model);
    if (node < 0) {
        auto const bounds = bounds_of(scene, 0);
        auto const pose = look_at(framing_eye(bounds, glm::normalize(glm::vec3{0.6f, 0.4f, 1.f}), default_field_of_view), bounds.centre(),
                                  default_field_of_view);
        scene.camera = [pose](float) { return pose; };
        return;
    }
    auto const number = model.content.nodes[static_cast<std::size_t>(node)].camera;
    auto const field_of_view = static_cast<float>(model.content.cameras[static_cast<std::size_t>(number)].perspective.yfov);
    if (!CameraPose{.vertical_field_of_view = field_of_view}.is_usable())
        throw model.error("its camera's yfov is " + std::to_string(field_of_view), "give it more than 0 and less than 3.14159");
    if (!CameraPose{scene.node_matrix(node, 0), field_of_view}.is_usable())
        throw model.error("its camera, node " + std::to_string(node) + ", is scaled to nothing, not finite, or far off",
                          "give that node, and those that it is in, another scale");
    // The nodes are copied, so that the camera doesn't depend on where the description lies.
    scene.camera = [nodes = scene.nodes, node, field_of_view](float frame) {
        return CameraPose{node_matrix(nodes, node, frame), field_of_view};
    };
}

void add_default_light(SceneDescription& scene) {
    bool const has_light = std::ranges::any_of(scene.instances, [&](SceneInstance const& instance) {
        return glm::length(scene.materials[static_cast<std::size_t>(instance.material)].emission) > 0;
    });
    if (has_light) return;
    scene.background = {{0.25f, 0.24f, 0.22f}, {0.75f, 0.9f, 1.2f}};
    auto const bounds = bounds_of(scene, 0);
    constexpr float distance = 6, radius = 0.4f, irradiance = 3;
    auto const place = bounds.centre() + glm::normalize(glm::vec3{0.35f, 1, 0.3f}) * (distance * bounds.radius());
    float const radiance = irradiance / (3.14159f * radius * radius / (distance * distance));
    scene.place(scene.add_sphere(), scene.add(Material{.emission = glm::vec3{1, 0.93f, 0.82f} * radiance}),
                Transform{.translation = place, .scale = glm::vec3{radius * bounds.radius()}});
    // Just below the lowest point, so that a floor of the file's own stays on top.
    glm::vec3 const foot{bounds.centre().x, bounds.least.y - 1e-3f * bounds.radius(), bounds.centre().z};
    scene.place(scene.add(rectangle(40 * bounds.radius(), 40 * bounds.radius())), scene.add(Material{.base = glm::vec3{0.45f}}),
                Transform{.translation = foot});
}

} // namespace gltf
} // namespace quell::tracer
