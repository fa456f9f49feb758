#pragma once

#include <array>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace quell_library {

/// What several units made of their shares of all presets, one after the other, which is the order of quell::all_presets.
template <class Made, std::size_t units> std::vector<Made> joined(std::array<std::vector<Made>, units> made) {
    std::vector<Made> all;
    for (auto& unit : made) all.insert(all.end(), std::move_iterator(unit.begin()), std::move_iterator(unit.end()));
    return all;
}

} // namespace quell_library
