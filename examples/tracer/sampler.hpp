#pragma once

#include "math.hpp"

#include <cstdint>

namespace quell::tracer {

// Owen-scrambled Sobol points with hashed scrambles (Burley, "Practical Hash-based Owen Scrambling", JCGT 2020), padded in pairs of
// dimensions. Chosen over blue noise because successive frames of one pixel continue one sequence: what a denoiser accumulates over time is
// then stratified over time, while pixels stay independent of each other, so no spatial filter sees a structure that is not in the scene.

/// Which point of the sequence: everything that a sample depends on.
struct SampleKey {
    glm::ivec2 pixel{0};
    std::uint32_t index = 0; ///< frame number * samples per pixel + sample number
    std::uint32_t seed = 0;
};

/// What a pair of random numbers is for. Each use owns a pair of dimensions, so tracing fewer effects changes nothing in the others.
enum class SampleUse : std::uint32_t {
    time,
    light_point,
    light_choice,
    glossy,
    indirect,
    second_light_point,
    second_light_choice,
    pixel_filter = 8,
    lens,
    see_through
};

namespace detail {

/// A bijection on 32 bits with good avalanche (constants: Wellons, "hash prospector", lowbias32).
constexpr std::uint32_t mix_bits(std::uint32_t x) {
    x ^= x >> 16;
    x *= 0x7feb352du;
    x ^= x >> 15;
    x *= 0x846ca68bu;
    return x ^ (x >> 16);
}

constexpr std::uint32_t combine(std::uint32_t a, std::uint32_t b) {
    return mix_bits(a ^ (mix_bits(b) + 0x9e3779b9u + (a << 6) + (a >> 2)));
}

constexpr std::uint32_t reverse_bits(std::uint32_t x) {
    x = (x & 0x55555555u) << 1 | (x >> 1 & 0x55555555u);
    x = (x & 0x33333333u) << 2 | (x >> 2 & 0x33333333u);
    x = (x & 0x0f0f0f0fu) << 4 | (x >> 4 & 0x0f0f0f0fu);
    x = (x & 0x00ff00ffu) << 8 | (x >> 8 & 0x00ff00ffu);
    return x << 16 | x >> 16;
}

/// Each bit is flipped depending on the lower bits only: on reversed digits this is an Owen scramble (Laine and Karras 2011).
constexpr std::uint32_t scramble_upwards(std::uint32_t x, std::uint32_t seed) {
    x += seed;
    x ^= x * 0x6c50b47cu;
    x ^= x * 0xb82f1e52u;
    x ^= x * 0xc7afe638u;
    return x ^ (x * 0x8d22f6e6u);
}

/// Second Sobol dimension, first digit in bit 0: its generator matrix is Pascal's triangle modulo 2, which factors into five butterflies.
constexpr std::uint32_t pascal(std::uint32_t x) {
    x ^= x >> 1 & 0x55555555u;
    x ^= x >> 2 & 0x33333333u;
    x ^= x >> 4 & 0x0f0f0f0fu;
    x ^= x >> 8 & 0x00ff00ffu;
    return x ^ (x >> 16);
}

constexpr float unit_interval(std::uint32_t bits) { return static_cast<float>(bits >> 8) * 0x1p-24f; }

} // namespace detail

/// Two numbers in [0, 1) for one use; `depth` tells apart the uses by different paths.
constexpr glm::vec2 sample_pair(SampleKey const& key, SampleUse use, std::uint32_t depth = 0) {
    using namespace detail;
    auto const pixel = combine(static_cast<std::uint32_t>(key.pixel.x), static_cast<std::uint32_t>(key.pixel.y));
    auto const scramble = combine(combine(pixel, key.seed), static_cast<std::uint32_t>(use) + 16u * depth);
    auto const index = scramble_upwards(reverse_bits(key.index), scramble);
    // The index is shuffled as an Owen scramble does it, so that pairs of dimensions are independent of each other.
    auto const shuffled = reverse_bits(index);
    auto const first = scramble_upwards(shuffled, mix_bits(scramble ^ 0x68bc21ebu));
    auto const second = scramble_upwards(pascal(shuffled), mix_bits(scramble ^ 0x02e5be93u));
    return {unit_interval(reverse_bits(first)), unit_interval(reverse_bits(second))};
}

/// A sample that takes no notice of the others of its pixel, in [0, 1).
constexpr float lone_sample(SampleKey const& key, SampleUse use) {
    using namespace detail;
    auto const pixel = combine(static_cast<std::uint32_t>(key.pixel.x), static_cast<std::uint32_t>(key.pixel.y));
    return unit_interval(combine(combine(combine(pixel, key.seed), static_cast<std::uint32_t>(use)), key.index));
}

} // namespace quell::tracer
