#pragma once

#include <quell/metrics/picture.hpp>

#include <glm/geometric.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::metrics {

/// Root of the mean squared difference over the selected pixels and their three components: 0 if equal, at most 1.
/// @throws Error where sizes differ, a component is outside [0, 1], or the mask does not fit or selects nothing
[[nodiscard]] inline double rmse(Picture const& reference, Picture const& test, Mask const& mask = {}) {
    detail::check_pair(reference, test);
    return std::sqrt(detail::mean_over(reference.size, mask, [&](std::size_t i) {
        auto const difference = glm::dvec3(test.pixels[i]) - glm::dvec3(reference.pixels[i]);
        return glm::dot(difference, difference) / 3.;
    }));
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::metrics
