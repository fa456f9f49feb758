#pragma once

#include <quell/core/instruction_set.hpp>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Share of "yes" among the cases that were asked.
struct Tally {
    long long yes = 0, asked = 0;

    void add(bool agrees) { yes += agrees, ++asked; }
    [[nodiscard]] double share() const { return asked > 0 ? static_cast<double>(yes) / static_cast<double>(asked) : 0.; }
};

/// Median (the upper one of an even number); 0 if empty. Reorders the values.
inline float median(std::vector<float>& values) {
    if (values.empty()) return 0.f;
    auto const middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Numbers as text: "37%", "0.25".
inline std::string percent(double share) {
    char text[32];
    std::snprintf(text, sizeof text, share > 0 && share < 0.01 ? "%.2f%%" : "%.0f%%", 100 * share);
    return text;
}
inline std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
}
inline std::string pair(double x, double y) { return "(" + number(x) + ", " + number(y) + ")"; }

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
