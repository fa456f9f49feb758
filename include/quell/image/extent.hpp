#pragma once

#include <string>

namespace quell {

/// Width and height in pixels.
struct Extent {
    int width = 0, height = 0;
    friend constexpr bool operator==(Extent, Extent) = default;
    [[nodiscard]] constexpr long long pixels() const { return static_cast<long long>(width) * height; }
};

/// The size of an image that is a fraction as wide and high, rounded up.
constexpr Extent divided(Extent size, int fraction) {
    return {(size.width + fraction - 1) / fraction, (size.height + fraction - 1) / fraction};
}

inline std::string to_string(Extent size) { return std::to_string(size.width) + "x" + std::to_string(size.height); }

} // namespace quell
