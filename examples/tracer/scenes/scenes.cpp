#include "scenes.hpp"

#include <quell/core/error.hpp>

#include <algorithm>
#include <array>

namespace quell::tracer {
namespace {

struct Entry {
    std::string_view name;
    SceneDescription (*make)();
};

constexpr std::array entries{Entry{"room", room},
                             Entry{"fence", fence},
                             Entry{"fence-lights", fence_with_lights},
                             Entry{"apples", apples},
                             Entry{"pinkroom", pinkroom},
                             Entry{"temple", temple},
                             Entry{"restaurant", restaurant},
                             Entry{"boxes", boxes},
                             Entry{"disk", disk},
                             Entry{"spheres", spheres},
                             Entry{"colonnade", colonnade},
                             Entry{"colonnade-slow", colonnade_slow},
                             Entry{"propeller", propeller},
                             Entry{"roll", roll},
                             Entry{"mixed", mixed},
                             Entry{"flyby", flyby},
                             Entry{"cut", cut},
                             Entry{"lightswitch", lightswitch},
                             Entry{"leaves", leaves},
                             Entry{"pan", pan},
                             Entry{"thinshadows", thinshadows},
                             Entry{"reverse", reverse}};

std::string listed(std::vector<std::string> const& names) {
    std::string list;
    for (auto const& name : names) list += (list.empty() ? "" : ", ") + name;
    return list;
}

} // namespace

std::vector<std::string> scene_names() {
    std::vector<std::string> names;
    for (auto const& entry : entries) names.emplace_back(entry.name);
    return names;
}

SceneDescription built_in_scene(std::string_view name) {
    auto const found = std::ranges::find(entries, name, &Entry::name);
    if (found == entries.end())
        throw Error{"scene '" + std::string{name} + "'", "no built-in scene has this name",
                    "use one of " + listed(scene_names()) + ", or a path to a .gltf or .glb file"};
    auto scene = found->make();
    scene.name = name;
    return scene;
}

} // namespace quell::tracer
