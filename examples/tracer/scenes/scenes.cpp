#include "scenes.hpp"

#include <quell/core/error.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace quell::tracer {

// One function per scene, and one file but for variants.
SceneDescription room(), fence(), fence_with_lights(), apples(), pinkroom(), temple(), restaurant(), boxes(), disk(), spheres(),
    colonnade(), colonnade_slow(), propeller(), roll(), mixed(), flyby(), cut(), lightswitch(), leaves(), pan(), thinshadows(), reverse(),
    lens(), pane();

std::vector<BuiltInScene> const& built_in_scenes() {
    static std::vector<BuiltInScene> const scenes{
        {"room", room, {"composite", "shadow", "glossy", "indirect"}},
        {"fence", fence, {"shadow"}},
        {"fence-lights", fence_with_lights, {"shadow"}},
        {"apples", apples, {"shadow"}},
        {"pinkroom", pinkroom, {"shadow"}},
        {"temple", temple, {"glossy"}},
        {"restaurant", restaurant, {"glossy"}},
        {"boxes", boxes, {"indirect"}},
        {"disk", disk, {"indirect"}},
        {"spheres", spheres, {"blur"}},
        {"colonnade", colonnade, {"blur"}},
        {"colonnade-slow", colonnade_slow, {"blur"}},
        {"propeller", propeller, {"blur"}},
        {"roll", roll, {"blur"}},
        {"mixed", mixed, {"blur"}},
        {"flyby", flyby, {"blur"}},
        {"cut", cut, {"composite"}},
        {"lightswitch", lightswitch, {"composite", "indirect"}},
        {"leaves", leaves, {"shadow"}},
        {"pan", pan, {"indirect"}},
        {"thinshadows", thinshadows, {"shadow"}},
        {"reverse", reverse, {"blur"}},
        {"lens", lens, {"composite"}},
        {"pane", pane, {"composite"}},
    };
    return scenes;
}

std::vector<std::string> scene_names() {
    std::vector<std::string> names;
    for (auto const& scene : built_in_scenes()) names.emplace_back(scene.name);
    return names;
}

SceneDescription built_in_scene(std::string_view name) {
    auto const found = std::ranges::find(built_in_scenes(), name, &BuiltInScene::name);
    if (found == built_in_scenes().end())
        throw Error{"scene '" + std::string{name} + "'", "no built-in scene has this name",
                    fmt::format("use one of {}, or a path to a .gltf or .glb file", fmt::join(scene_names(), ", "))};
    auto scene = found->make();
    scene.name = name;
    return scene;
}

} // namespace quell::tracer
