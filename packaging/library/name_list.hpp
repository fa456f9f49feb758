#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace quell_library {

/// Calls use(name) for each of some names between commas, without the spaces around them, until it returns true; whether it did.
constexpr bool any_name(std::string_view names, auto&& use) {
    while (!names.empty()) {
        auto const comma = names.find(',');
        auto name = names.substr(0, comma);
        name.remove_prefix(std::min(name.find_first_not_of(' '), name.size()));
        if (use(name.substr(0, name.find_last_not_of(' ') + 1))) return true;
        names.remove_prefix(comma == std::string_view::npos ? names.size() : comma + 1);
    }
    return false;
}
/// All of them.
inline std::vector<std::string> names_in(std::string_view names) {
    std::vector<std::string> all;
    any_name(names, [&](std::string_view name) { return all.emplace_back(name), false; });
    return all;
}
/// Whether a name is among those between commas. All are, where there are none: an option that is empty chooses nothing.
constexpr bool is_chosen(std::string_view names, std::string_view name) {
    return names.empty() || any_name(names, [&](auto one) { return one == name; });
}

} // namespace quell_library
