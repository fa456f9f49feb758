#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>

namespace quell::examples {

/// The bytes in base64 (RFC 4648, padded), the form in which a data URI carries them.
inline std::string encode_base64(std::span<unsigned char const> bytes) {
    static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text((bytes.size() + 2) / 3 * 4, '=');
    auto out = text.begin();
    for (std::size_t start = 0; start < bytes.size(); start += 3) {
        std::size_t const count = std::min<std::size_t>(3, bytes.size() - start);
        std::uint32_t group = 0;
        for (std::size_t i = 0; i < 3; ++i) group = group << 8 | (i < count ? bytes[start + i] : 0u);
        // n bytes fill n + 1 digits; the padding that the string began with stands in the rest.
        for (std::size_t i = 0; i < 4; ++i, ++out)
            if (i <= count) *out = digits[group >> (18 - 6 * i) & 63u];
    }
    return text;
}

} // namespace quell::examples
