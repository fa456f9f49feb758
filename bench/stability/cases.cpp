#include "cases.hpp"

#include <quell/core/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <ranges>

namespace quell::stability {

std::vector<Case> const& cases() {
    static std::vector<Case> const all = [] {
        std::vector<Case> list;
        for (auto const& family : {event_cases(), uncovering_cases(), shadow_cases(), reflection_cases(), blur_cases(), mixed_pixel_cases(),
                                   firefly_cases(), input_cases(), bounds_cases(), drift_cases(), host_mistake_cases(), upsampling_cases()})
            list.insert(list.end(), family.begin(), family.end());
        return list;
    }();
    return all;
}

Case const& case_of(std::string const& name) {
    auto const found = std::ranges::find(cases(), name, &Case::name);
    if (found != cases().end()) return *found;
    throw Error("--case", "there is no case '" + name + "'",
                fmt::format("choose one of: {}", fmt::join(cases() | std::views::transform(&Case::name), ", ")));
}

} // namespace quell::stability
