#include "cases.hpp"

#include <quell/core/error.hpp>
#include <tracer/scenes/scenes.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace quell::bench {
namespace {

using Effects = std::vector<std::string>;

void check_known(std::string const& effect) {
    if (std::ranges::find(effect_names(), effect) != effect_names().end()) return;
    throw Error("--effect", "there is no effect '" + effect + "'", fmt::format("choose from: {}", fmt::join(effect_names(), ", ")));
}

} // namespace

std::vector<std::string> const& effect_names() {
    static Effects const names{"shadow", "glossy", "curved", "indirect", "blur", "composite", "upsampled"};
    return names;
}

std::vector<std::string> effects_of(std::string const& scene) {
    auto const& scenes = tracer::built_in_scenes();
    auto const found = std::ranges::find(scenes, scene, &tracer::BuiltInScene::name);
    return found != scenes.end() ? Effects(found->effects.begin(), found->effects.end()) : Effects{"composite"};
}

std::vector<SceneEffect> cases_of(std::vector<std::string> const& scenes, std::vector<std::string> const& effects) {
    for (auto const& effect : effects) check_known(effect);
    bool const all = std::ranges::find(scenes, "all") != scenes.end();
    std::vector<SceneEffect> cases;
    for (auto const& scene : all ? tracer::scene_names() : scenes) {
        auto const its_own = effects_of(scene);
        // Of all scenes, only those that have the effect; of a scene that was asked for, whatever was asked for.
        for (auto const& effect : effects.empty() ? its_own : effects) {
            bool const wanted = !all || std::ranges::find(its_own, effect) != its_own.end();
            if (SceneEffect const one{scene, effect}; wanted && std::ranges::find(cases, one) == cases.end()) cases.push_back(one);
        }
    }
    if (cases.empty()) throw Error("--effect", "no built-in scene was made for it", "name a scene with --scene");
    return cases;
}

} // namespace quell::bench
