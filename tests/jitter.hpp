#pragma once

#include <glm/vec2.hpp>

/// Places of samples in their pixels.
namespace quell::tests {

/// The number `index` of the Halton sequence, from 1 on: its digits in a base, behind the point and in reverse.
inline float halton(int index, int base) {
    float digit = 1.f, result = 0.f;
    for (; index > 0; index /= base) {
        digit /= static_cast<float>(base);
        result += digit * static_cast<float>(index % base);
    }
    return result;
}
/// Where the samples of a frame lie, from the pixels' centres: Halton points, which begin anew after `period` frames.
inline glm::vec2 jitter_of(int number, int period = 16) {
    return {halton(number % period + 1, 2) - .5f, halton(number % period + 1, 3) - .5f};
}

} // namespace quell::tests
