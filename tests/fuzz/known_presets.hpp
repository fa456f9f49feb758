#pragma once

#include "arbitrary_frames.hpp"

#include <quell/presets/named.hpp>

#include <library/name_list.hpp>

namespace quell::fuzz {

/// Makes every `units`-th preset known from number `unit` on, as far as QUELL_FUZZ_PRESETS names them.
template <std::size_t unit, std::size_t units> bool make_presets_known() {
    for_each_preset_index<unit, units>([](auto i) {
        constexpr auto preset = std::get<i>(named_presets);
        if constexpr (quell_library::is_chosen(QUELL_FUZZ_PRESETS, preset.name)) known(std::string(preset.name), preset.usual());
    });
    return true;
}

} // namespace quell::fuzz
