#include "gltf.hpp"
#include "parts.hpp"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <memory>
#include <optional>

namespace quell::tracer::gltf {
namespace {

template <class Value> Value value_at(std::vector<float> const& values, std::size_t i) {
    if constexpr (std::is_same_v<Value, glm::quat>)
        return glm::quat{values[4 * i + 3], values[4 * i], values[4 * i + 1], values[4 * i + 2]};
    else
        return {values[3 * i], values[3 * i + 1], values[3 * i + 2]};
}

Interpolation interpolation_of(std::string const& name) {
    if (name == "STEP") return Interpolation::step;
    return name == "CUBICSPLINE" ? Interpolation::cubic : Interpolation::linear;
}

/// Cubic samplers store three values a key: tangent in, value, tangent out; tangents are per second.
template <class Value> Key<Value> key_at(std::vector<float> const& times, std::vector<float> const& values, std::size_t i, bool cubic) {
    Key<Value> key{.frame = times[i] * frames_per_second, .value = value_at<Value>(values, cubic ? 3 * i + 1 : i)};
    if (!cubic) return key;
    key.tangent_in = value_at<Value>(values, 3 * i) * (1 / frames_per_second);
    key.tangent_out = value_at<Value>(values, 3 * i + 2) * (1 / frames_per_second);
    return key;
}

/// All of an animation's samplers start over together, when the longest has ended; frames.
float period_of(Model const& model, tinygltf::Animation const& animation) {
    float last = 0;
    for (auto const& sampler : animation.samplers)
        for (float const time : model.floats(sampler.input, 1)) last = std::max(last, time);
    return last * frames_per_second;
}

template <class Value> Track<Value> track_of(Model const& model, tinygltf::AnimationSampler const& sampler, float period) {
    constexpr int components = std::is_same_v<Value, glm::quat> ? 4 : 3;
    auto const times = model.floats(sampler.input, 1), values = model.floats(sampler.output, components);
    Track<Value> track;
    track.interpolation = interpolation_of(sampler.interpolation);
    bool const cubic = track.interpolation == Interpolation::cubic;
    if (times.empty() || values.size() < times.size() * (cubic ? 3 : 1) * components)
        throw model.error("an animation has " + std::to_string(times.size()) + " times but " + std::to_string(values.size() / components) +
                          " values");
    for (std::size_t i = 0; i < times.size(); ++i) track.keys.push_back(key_at<Value>(times, values, i, cubic));
    track.period = period;
    return track;
}

/// One node's place, each part of which may be animated.
struct Animated {
    Transform rest;
    std::optional<Track<glm::vec3>> translation, scale;
    std::optional<Track<glm::quat>> rotation;

    [[nodiscard]] glm::mat4 at(float frame) const {
        return Transform{translation ? translation->at(frame) : rest.translation, rotation ? rotation->at(frame) : rest.rotation,
                         scale ? scale->at(frame) : rest.scale}
            .matrix();
    }
};

void add_channel(Model const& model, tinygltf::AnimationSampler const& sampler, float period, std::string const& path, Animated& node) {
    if (path == "translation" && !node.translation) node.translation = track_of<glm::vec3>(model, sampler, period);
    if (path == "scale" && !node.scale) node.scale = track_of<glm::vec3>(model, sampler, period);
    if (path == "rotation" && !node.rotation) node.rotation = track_of<glm::quat>(model, sampler, period);
}

Transform rest_of(tinygltf::Node const& node) {
    Transform rest;
    auto const vector = [](std::vector<double> const& v) { return glm::vec3{v[0], v[1], v[2]}; };
    if (node.translation.size() == 3) rest.translation = vector(node.translation);
    if (node.scale.size() == 3) rest.scale = vector(node.scale);
    if (node.rotation.size() == 4) {
        auto const& q = node.rotation;
        rest.rotation = glm::normalize(
            glm::quat{static_cast<float>(q[3]), static_cast<float>(q[0]), static_cast<float>(q[1]), static_cast<float>(q[2])});
    }
    return rest;
}

Pose pose_of(tinygltf::Node const& node, Animated const& animated) {
    if (node.matrix.size() == 16) return [matrix = glm::mat4(glm::make_mat4(node.matrix.data()))](float) { return matrix; };
    return [animated = std::make_shared<Animated>(animated)](float frame) { return animated->at(frame); };
}

/// Nodes are walked over by functions that call themselves.
constexpr int deepest = 1000;

/// A node inside itself would never end.
void check_hierarchy(Model const& model, SceneDescription const& scene) {
    for (auto const& node : scene.nodes) {
        int depth = 0;
        for (int parent = node.parent; parent >= 0; parent = scene.nodes[static_cast<std::size_t>(parent)].parent)
            if (++depth > deepest)
                throw model.error("its nodes contain each other, or lie more than " + std::to_string(deepest) + " deep in each other");
    }
}

/// A node in several places would stand in the scene as often as there are ways to it.
void set_parent(Model const& model, SceneDescription& scene, int child, int parent) {
    auto& node = scene.nodes[static_cast<std::size_t>(child)];
    if (node.parent >= 0) throw model.error("node " + std::to_string(child) + " is a child of two nodes, or twice of one");
    node.parent = parent;
}

} // namespace

void add_nodes(Model const& model, SceneDescription& scene) {
    auto const& nodes = model.content.nodes;
    std::vector<Animated> animated(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) animated[i].rest = rest_of(nodes[i]);
    for (auto const& animation : model.content.animations) {
        float const period = period_of(model, animation);
        for (auto const& channel : animation.channels) {
            if (channel.target_node < 0) continue;
            model.item(nodes, channel.target_node, "node");
            auto const& sampler = model.item(animation.samplers, channel.sampler, "animation sampler");
            add_channel(model, sampler, period, channel.target_path, animated[static_cast<std::size_t>(channel.target_node)]);
        }
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) scene.add_node(pose_of(nodes[i], animated[i]));
    for (std::size_t i = 0; i < nodes.size(); ++i)
        for (int child : nodes[i].children) {
            model.item(nodes, child, "node");
            set_parent(model, scene, child, static_cast<int>(i));
        }
    check_hierarchy(model, scene);
}

} // namespace quell::tracer::gltf
