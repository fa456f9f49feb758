#pragma once

#include <baselines/named.hpp>

#include <cstddef>

namespace quell_library {

/// Which of `units` shares a preset has, where as many as possible of those for which is_among(preset) holds are of each. Neighbours in
/// quell::all_presets are of one share: they have kernels in common, which every file that has one of them compiles anew.
/// @param i the preset's index
template <std::size_t units> consteval std::size_t share_of_preset(std::size_t i, auto is_among) {
    std::size_t before = 0, all = 0;
    quell::for_each_preset_index(quell::all_presets, [&](auto other) {
        if (!is_among(std::get<other>(quell::all_presets))) return;
        ++all;
        if (other < i) ++before;
    });
    return all == 0 ? 0 : before * units / all;
}

} // namespace quell_library
