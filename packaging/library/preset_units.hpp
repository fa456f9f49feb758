#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace quell_library {

/// What several units made of their shares of all presets, in the order of quell::named_presets again: unit i has the presets i, i + units,
/// and so on. Presets that are not compiled have no name, and are left out.
template <class Made, std::size_t units> std::vector<Made> in_order(std::array<std::vector<Made>, units> made) {
    std::vector<Made> all;
    for (std::size_t i = 0; i / units < made[i % units].size(); ++i)
        if (auto& one = made[i % units][i / units]; !one.name.empty()) all.push_back(std::move(one));
    return all;
}

} // namespace quell_library
