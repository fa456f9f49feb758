#pragma once

#include "../scene.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace quell::tracer {

/// Names of the built-in scenes, in the order of SCENES.md.
[[nodiscard]] std::vector<std::string> scene_names();

/// Throws quell::Error, listing the names, where there is no such scene.
[[nodiscard]] SceneDescription built_in_scene(std::string_view name);

// One function per scene, and one file but for variants; scenes.cpp lists them.
[[nodiscard]] SceneDescription room();
[[nodiscard]] SceneDescription fence();
[[nodiscard]] SceneDescription fence_with_lights();
[[nodiscard]] SceneDescription apples();
[[nodiscard]] SceneDescription pinkroom();
[[nodiscard]] SceneDescription temple();
[[nodiscard]] SceneDescription restaurant();
[[nodiscard]] SceneDescription boxes();
[[nodiscard]] SceneDescription disk();
[[nodiscard]] SceneDescription spheres();
[[nodiscard]] SceneDescription colonnade();
[[nodiscard]] SceneDescription colonnade_slow();
[[nodiscard]] SceneDescription propeller();
[[nodiscard]] SceneDescription roll();
[[nodiscard]] SceneDescription mixed();
[[nodiscard]] SceneDescription flyby();

} // namespace quell::tracer
