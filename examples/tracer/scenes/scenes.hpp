#pragma once

#include "../scene.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace quell::tracer {

/// A built-in scene.
struct BuiltInScene {
    std::string_view name;
    SceneDescription (*make)();
    std::vector<std::string_view> effects; ///< what it was made for: composite, shadow, glossy, curved, indirect, blur
};

/// All of them: the table of scenes.cpp.
[[nodiscard]] std::vector<BuiltInScene> const& built_in_scenes();

[[nodiscard]] std::vector<std::string> scene_names();

/// Throws quell::Error, listing the names, where there is no such scene.
[[nodiscard]] SceneDescription built_in_scene(std::string_view name);

/// The first frame that shows what happens once in the scenes named for an event: the camera
/// is somewhere else, the light is on, the leaves begin to open, the camera to turn, and something moves back.
inline constexpr float event_frame = 24;

} // namespace quell::tracer
