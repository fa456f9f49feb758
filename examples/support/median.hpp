#pragma once

#include <algorithm>
#include <limits>
#include <vector>

namespace quell::examples {

/// The middle value, the upper one of an even number; NaN where there is none.
[[nodiscard]] inline double median(std::vector<double> values) {
    if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
    auto const middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

} // namespace quell::examples
