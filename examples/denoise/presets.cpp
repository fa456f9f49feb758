#include <denoise/presets.hpp>

#include <quell/core/error.hpp>

#include <algorithm>

namespace quell::examples {

std::vector<Preset> const& presets() {
    static std::vector<Preset> const all = [] {
        std::vector<Preset> list;
        for (auto const& family : {temporal_presets(), spatial_presets(), spatiotemporal_presets(), effect_presets(), blur_presets()})
            list.insert(list.end(), family.begin(), family.end());
        return list;
    }();
    return all;
}

Preset const& preset_of(std::string const& name) {
    auto const found = std::ranges::find(presets(), name, &Preset::name);
    if (found != presets().end()) return *found;
    std::string names;
    for (auto const& preset : presets()) names += (names.empty() ? "" : ", ") + preset.name;
    throw Error("--preset", "there is no preset '" + name + "'", "choose one of: " + names);
}

} // namespace quell::examples
