#pragma once

#include <string>
#include <vector>

namespace quell::bench {

/// An effect on a scene.
struct SceneEffect {
    std::string scene, effect;
    bool operator==(SceneEffect const&) const = default;
};

/// shadow, glossy, curved (glossy in curved reflectors), indirect, blur, composite (all effects at once), and upsampled (all at once, of
/// frames of half the width and height).
[[nodiscard]] std::vector<std::string> const& effect_names();

/// What is worth charting on a scene. One that isn't built in is charted as a whole.
[[nodiscard]] std::vector<std::string> effects_of(std::string const& scene);

/// These effects on these scenes, each once; without effects, those that the scenes have.
/// @param scenes built-in names, files, or `all` for every built-in scene
/// @throws Error for an effect that there isn't
[[nodiscard]] std::vector<SceneEffect> cases_of(std::vector<std::string> const& scenes, std::vector<std::string> const& effects);

} // namespace quell::bench
