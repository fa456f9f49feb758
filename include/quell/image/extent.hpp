#pragma once

#include <quell/core/instruction_set.hpp>

#include <string>

namespace quell::inline QUELL_INSTRUCTION_SET {

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
    // Not (a + b - 1) / b, which overflows for sizes that are refused only later.
    auto const up = [&](int length) { return length / fraction + (length % fraction > 0 ? 1 : 0); };
    return {up(size.width), up(size.height)};
}

/// Text for messages, such as "1920x1080".
inline std::string to_string(Extent size) { return std::to_string(size.width) + "x" + std::to_string(size.height); }

} // namespace quell::inline QUELL_INSTRUCTION_SET
