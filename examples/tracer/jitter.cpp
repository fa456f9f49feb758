#include "jitter.hpp"

#include <algorithm>

namespace quell::tracer {
namespace {

constexpr int period = 16;

float halton(int index, int base) {
    float digit = 1, result = 0;
    for (; index > 0; index /= base) {
        digit /= static_cast<float>(base);
        result += digit * static_cast<float>(index % base);
    }
    return result;
}

/// The integral of a Blackman-Harris window of width and weight 1, from its left end at -0.5.
double window_integral(double x) {
    constexpr double pi = std::numbers::pi;
    double const waves = 0.48829 * std::sin(2 * pi * x) + 0.14128 / 2 * std::sin(4 * pi * x) + 0.01168 / 3 * std::sin(6 * pi * x);
    return 0.5 + x + waves / (2 * pi * 0.35875);
}

constexpr std::size_t intervals = 1024;

std::array<double, intervals + 1> tabulated() {
    std::array<double, intervals + 1> table;
    for (std::size_t i = 0; i <= intervals; ++i) table[i] = window_integral(static_cast<double>(i) / intervals - 0.5);
    return table;
}

/// Inverts the integral. The integral is what is tabulated, not its inverse, whose slope at the ends is too steep for straight lines.
float inverse_of_integral(float uniform) {
    static auto const table = tabulated();
    auto const above = std::upper_bound(table.begin() + 1, table.end() - 1, static_cast<double>(uniform));
    double const low = *(above - 1), part = (uniform - low) / (*above - low);
    return static_cast<float>((static_cast<double>(above - table.begin() - 1) + part) / intervals - 0.5);
}

} // namespace

std::string_view name_of(Jitter jitter) {
    constexpr std::string_view names[]{"none", "frame", "pixel"};
    return names[static_cast<std::size_t>(jitter)];
}

glm::vec2 camera_jitter(Jitter jitter, int frame) {
    if (jitter != Jitter::frame) return glm::vec2{0.f};
    int const index = (frame % period + period) % period + 1; // the first Halton point, 0, is a corner
    return glm::vec2{halton(index, 2), halton(index, 3)} - 0.5f;
}

glm::vec2 filter_offset(glm::vec2 uniform) {
    return 2 * filter_radius * glm::vec2{inverse_of_integral(uniform.x), inverse_of_integral(uniform.y)};
}

} // namespace quell::tracer
