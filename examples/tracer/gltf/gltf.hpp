#pragma once

#include "../scene.hpp"

#include <filesystem>
#include <optional>

namespace quell::tracer {

/// glTF counts seconds; a second is this many frames.
inline constexpr float frames_per_second = 24;

/// Where to look from; what is left out comes from the file's camera or, without one, frames the whole scene.
struct CameraChoice {
    std::optional<glm::vec3> eye{}, target{};
    std::optional<float> field_of_view{}; ///< vertical, degrees
    float orbit = 0;                      ///< degrees per frame around the target's vertical axis
    glm::vec3 dolly{0.f};                 ///< movement per frame of both eye and target

    [[nodiscard]] bool is_default() const { return !eye && !target && !field_of_view && orbit == 0 && dolly == glm::vec3{0.f}; }
};

/// Loads a glTF 2.0 file, text or binary: node hierarchy and animation, skinning, base colour, metallic, roughness, emission, alpha masks.
/// The first animation that moves a node does so, over and over. Emissive triangles are the lights; a file without any gets a sky, a
/// large soft sun and a ground to stand on. Not supported, and ignored: normal maps, transparency beyond masks, morph targets, punctual
/// lights, orthographic cameras. Throws quell::Error that names the file, what was found there, and what to do.
[[nodiscard]] SceneDescription load_gltf(std::filesystem::path const& path, CameraChoice const& camera = {});

/// Gives any scene another camera.
void choose_camera(SceneDescription& scene, CameraChoice const& camera);

/// A built-in scene by its name, or a file by its path (anything that ends in .gltf or .glb).
[[nodiscard]] SceneDescription open_scene(std::string const& name_or_path, CameraChoice const& camera = {});

} // namespace quell::tracer
