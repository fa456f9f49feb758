#pragma once

#include <string_view>

namespace quell_library {

/// Calls use(name) for each of some names between commas, until it returns true; whether it did.
constexpr bool any_name(std::string_view names, auto&& use) {
    while (!names.empty()) {
        auto const comma = names.find(',');
        if (use(names.substr(0, comma))) return true;
        names.remove_prefix(comma == std::string_view::npos ? names.size() : comma + 1);
    }
    return false;
}
/// Whether a name is among those between commas. All are, where there are none: an option that is empty chooses nothing.
constexpr bool is_chosen(std::string_view names, std::string_view name) {
    return names.empty() || any_name(names, [&](auto one) { return one == name; });
}

} // namespace quell_library
