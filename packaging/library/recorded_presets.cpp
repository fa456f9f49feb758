#include "recorded_presets.hpp"

#include "preset_units.hpp"

namespace quell::shaders {

std::vector<RecordedPreset> recorded_presets() {
    return []<std::size_t... unit>(std::index_sequence<unit...>) { return quell_library::in_order(std::array{presets_of_unit<unit>()...}); }
    (std::make_index_sequence<QUELL_RECORDED_UNITS>{});
}

} // namespace quell::shaders
