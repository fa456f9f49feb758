#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

// What a fuzzer's bytes mean to frames: a few choices first, then words from which pixels are made.
namespace quell::fuzz {

/// Reads bytes in order; behind the end there are zeros.
class Bytes {
    std::span<std::uint8_t const> left;

public:
    explicit Bytes(std::span<std::uint8_t const> all) : left(all) {}

    std::uint8_t byte() {
        if (left.empty()) return 0;
        auto const first = left.front();
        left = left.subspan(1);
        return first;
    }
    std::uint32_t word() {
        std::uint32_t value = 0;
        for (int i = 0; i < 4; ++i) value |= static_cast<std::uint32_t>(byte()) << (8 * i);
        return value;
    }
    [[nodiscard]] std::span<std::uint8_t const> rest() const { return left; }
};

/// Numbers at which arithmetic changes its ways.
inline constexpr float turning_points[] = {std::numeric_limits<float>::quiet_NaN(),
                                           std::numeric_limits<float>::infinity(),
                                           -std::numeric_limits<float>::infinity(),
                                           std::numeric_limits<float>::max(),
                                           std::numeric_limits<float>::lowest(),
                                           std::numeric_limits<float>::min(),
                                           std::numeric_limits<float>::denorm_min(),
                                           0.f,
                                           -0.f,
                                           1.f,
                                           -1.f,
                                           1e16f,
                                           2.1e9f,
                                           -2.1e9f,
                                           65504.f,
                                           1e-20f};

/// An endless supply of bit patterns: turning points of arithmetic, words of the input, and any bits at all.
class Patterns {
    std::span<std::uint8_t const> words;
    std::uint32_t state;

    std::uint32_t random() {
        state = state * 1664525u + 1013904223u;
        return state ^ state >> 16;
    }
    std::uint32_t word_of_input() {
        auto const start = random() % (words.size() / 4) * 4;
        return Bytes(words.subspan(start)).word();
    }

public:
    Patterns(std::uint32_t seed, std::span<std::uint8_t const> words_) : words(words_), state(seed) {}

    float next() {
        auto const kind = random() >> 8 & 3;
        if (kind == 0) return turning_points[random() >> 8 & 15];
        if (kind == 1 || words.size() < 4) return std::bit_cast<float>(random() << 16 | random() >> 16);
        return std::bit_cast<float>(word_of_input());
    }
    /// True with a chance of `parts` in 256.
    bool chance(std::uint32_t parts) { return (random() >> 8 & 255) < parts; }
};

} // namespace quell::fuzz
