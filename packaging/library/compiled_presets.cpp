#include "compiled_preset.hpp"
#include "preset_units.hpp"

#include <algorithm>

namespace quell_library {

namespace {
template <bool published, std::size_t... i> std::vector<CompiledPreset> of_units(std::index_sequence<i...>) {
    return joined(std::array{compiled_presets_of_unit<published, i, sizeof...(i)>()...});
}
} // namespace

std::vector<CompiledPreset> const& compiled_presets() {
    static auto const all = [] {
        std::vector<CompiledPreset> made;
#if QUELL_PRESET_UNITS > 0
        made = of_units<false>(std::make_index_sequence<QUELL_PRESET_UNITS>{});
#endif
#if QUELL_PUBLISHED_UNITS > 0
        std::ranges::move(of_units<true>(std::make_index_sequence<QUELL_PUBLISHED_UNITS>{}), std::back_inserter(made));
#endif
        return made;
    }();
    return all;
}

} // namespace quell_library
