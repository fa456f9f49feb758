#pragma once

#include <string>

namespace quell {

/// An image size in pixels.
struct Extent {
    int width = 0,  ///< pixels
        height = 0; ///< pixels

    /// Equal in width and height.
    friend constexpr bool operator==(Extent, Extent) = default;
    /// Width times height.
    [[nodiscard]] constexpr long long pixels() const { return static_cast<long long>(width) * height; }
};

/// size / fraction, rounded up in both directions.
constexpr Extent divided(Extent size, int fraction) {
    return {(size.width + fraction - 1) / fraction, (size.height + fraction - 1) / fraction};
}

/// Text for messages, such as "1920x1080".
inline std::string to_string(Extent size) { return std::to_string(size.width) + "x" + std::to_string(size.height); }

} // namespace quell
