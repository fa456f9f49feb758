#include <denoise/isa_choice.hpp>

#include <algorithm>
#include <optional>

namespace quell_isa {

namespace {

std::string names_of(std::vector<Isa> const& built, bool only_running) {
    std::string names;
    for (auto const& isa : built)
        if (isa.runs_here || !only_running) names.append(names.empty() ? "" : ", ").append(isa.name);
    return names;
}

/// The last one counts, as for other options.
std::optional<std::string_view> asked_for(std::vector<std::string_view> const& arguments) {
    std::optional<std::string_view> name;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        if (arguments[i].starts_with("--isa=")) name = arguments[i].substr(6);
        if (arguments[i] == "--isa") name = i + 1 < arguments.size() ? arguments[i + 1] : std::string_view();
    }
    return name;
}

} // namespace

Choice choose_isa(std::vector<Isa> const& built, std::vector<std::string_view> const& arguments) {
    auto const running = names_of(built, true);
    if (running.empty()) return {.error = "this machine runs none of " + names_of(built, false) + "; build for an older one"};
    auto const name = asked_for(arguments);
    if (!name) return {.name = std::string(std::ranges::find_if(built, &Isa::runs_here)->name)};
    auto const found = std::ranges::find(built, *name, &Isa::name);
    std::string const asked(*name);
    if (found == built.end()) return {.error = "--isa: this program has no code for '" + asked + "'; choose one of: " + running};
    if (!found->runs_here) return {.error = "--isa: this machine does not run " + asked + "; choose one of: " + running};
    return {.name = asked};
}

} // namespace quell_isa
