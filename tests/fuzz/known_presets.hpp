#pragma once

#include "arbitrary_frames.hpp"

#include <baselines/named.hpp>

#include <library/name_list.hpp>
#include <library/preset_share.hpp>

namespace quell::fuzz {

/// Whether QUELL_FUZZ_PRESETS names a preset.
inline constexpr auto is_named = [](auto const& preset) { return quell_library::is_chosen(QUELL_FUZZ_PRESETS, preset.name); };

/// Makes a share of the presets known that QUELL_FUZZ_PRESETS names, number `unit` of `units`.
template <std::size_t unit, std::size_t units> bool make_presets_known() {
    for_each_preset_index(all_presets, [](auto i) {
        constexpr auto preset = std::get<i>(all_presets);
        if constexpr (is_named(preset))
            if constexpr (quell_library::share_of_preset<units>(i, is_named) == unit) known(std::string(preset.name), preset.usual());
    });
    return true;
}

} // namespace quell::fuzz
