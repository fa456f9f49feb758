#include "recorded_presets.hpp"

#include "preset_units.hpp"

#include <quell/core/error.hpp>

#include <algorithm>

namespace quell::shaders {

std::vector<RecordedPreset> recorded_presets() {
    return []<std::size_t... unit>(std::index_sequence<unit...>) {
        return quell_library::joined(std::array{presets_of_unit<unit>()..., recorded_stages()});
    }
    (std::make_index_sequence<QUELL_RECORDED_UNITS>{});
}

ShaderPlan recorded_preset_named(std::string_view name, RecordOptions const& options, float samples) {
    auto const all = recorded_presets();
    auto const found = std::ranges::find(all, name, &RecordedPreset::name);
    if (found == all.end())
        raise_error("preset " + std::string(name), "there is none, or it is not compiled in", "take one of quell-shaders --list");
    return found->record(options, samples);
}

} // namespace quell::shaders
