#pragma once

#include "results.hpp"
#include "scored_sequence.hpp"

#include <string>
#include <vector>

namespace quell::stability {

/// A situation in which methods of some kind are known to fail.
struct Case {
    std::string name;
    std::string about; ///< what happens, and what is promised
    void (*run)(std::string const& name, Making const& making, Results& results);
};

/// In the catalogue's order.
[[nodiscard]] std::vector<Case> const& cases();
/// @throws Error, listing the names, where there is no such case
[[nodiscard]] Case const& case_of(std::string const& name);

// One function and one file per family.
[[nodiscard]] std::vector<Case> event_cases();
[[nodiscard]] std::vector<Case> uncovering_cases();
[[nodiscard]] std::vector<Case> shadow_cases();
[[nodiscard]] std::vector<Case> reflection_cases();
[[nodiscard]] std::vector<Case> blur_cases();
[[nodiscard]] std::vector<Case> mixed_pixel_cases();
[[nodiscard]] std::vector<Case> firefly_cases();
[[nodiscard]] std::vector<Case> input_cases();
[[nodiscard]] std::vector<Case> bounds_cases();
[[nodiscard]] std::vector<Case> drift_cases();
[[nodiscard]] std::vector<Case> host_mistake_cases();
[[nodiscard]] std::vector<Case> upsampling_cases();

} // namespace quell::stability
