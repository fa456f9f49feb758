#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace quell::examples {

/// The channel maps of maps/, which are compiled into the program: names and JSON, in the alphabet's order.
[[nodiscard]] std::vector<std::pair<std::string_view, std::string_view>> const& renderer_maps();

/// The map of that name; null if there is none.
[[nodiscard]] inline std::string_view const* find_renderer_map(std::string_view name) {
    for (auto const& [renderer, text] : renderer_maps())
        if (renderer == name) return &text;
    return nullptr;
}

/// All names, with commas.
[[nodiscard]] inline std::string names_of_renderers() {
    std::string names;
    for (auto const& [renderer, text] : renderer_maps()) names += (names.empty() ? "" : ", ") + std::string(renderer);
    return names;
}

} // namespace quell::examples
