#pragma once

#include <quell/core/instruction_set.hpp>

#include <cstddef>
#include <string_view>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// A preset's file in quell/presets/, and its group where programs list it. Published ones are baselines, which are not installed.
enum class PresetGroup { general, effects, blur, published };

/// @returns the group's name: that of its file
constexpr std::string_view to_string(PresetGroup group) {
    constexpr std::string_view names[] = {"general", "effects", "blur", "published"};
    return names[static_cast<std::size_t>(group)];
}

} // namespace quell::inline QUELL_INSTRUCTION_SET
