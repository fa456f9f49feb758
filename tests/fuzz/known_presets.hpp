#pragma once

#include "arbitrary_frames.hpp"

#include <quell/presets/named.hpp>

namespace quell::fuzz {

/// Whether the program is to have a preset: QUELL_FUZZ_PRESETS is "all" or names them, with a space around each.
constexpr bool is_wanted(std::string_view name) {
    std::string_view const wanted = QUELL_FUZZ_PRESETS;
    for (std::size_t at = wanted.find(name); at != wanted.npos; at = wanted.find(name, at + 1))
        if (wanted[at - 1] == ' ' && wanted[at + name.size()] == ' ') return true;
    return wanted == "all";
}

/// Makes every `units`-th preset known from number `unit` on, as far as they are wanted.
template <std::size_t unit, std::size_t units> bool make_presets_known() {
    for_each_preset_index<unit, units>([](auto i) {
        constexpr auto preset = std::get<i>(named_presets);
        if constexpr (is_wanted(preset.name)) known(std::string(preset.name), preset.usual());
    });
    return true;
}

} // namespace quell::fuzz
