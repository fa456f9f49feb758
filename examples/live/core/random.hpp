#pragma once

#include "turn.hpp"

#include <stdint.h>

namespace quell::live {

/// Random numbers of one sample. They depend on the pixel, the frame and the sample alone, so that a picture is the same in whatever order
/// its pixels are traced. A permuted congruential generator (O'Neill 2014).
struct Random {
    uint32_t state = 0; ///< of the generator

    Random() = default;
    /// Those of a sample.
    QUELL_LIVE Random(int x, int y, uint32_t frame, int sample) {
        state = static_cast<uint32_t>(x);
        uint32_t const others[] = {static_cast<uint32_t>(y), frame, static_cast<uint32_t>(sample)};
        for (uint32_t const other : others) state = bits() ^ other * 0x9e3779b9u;
    }
    /// 32 random bits.
    QUELL_LIVE uint32_t bits() {
        state = state * 747796405u + 2891336453u;
        uint32_t const word = ((state >> ((state >> 28) + 4)) ^ state) * 277803737u;
        return (word >> 22) ^ word;
    }
    /// Even in [0, 1).
    QUELL_LIVE float next() { return static_cast<float>(bits() >> 8) * 0x1p-24f; }
    /// Even on the sphere of radius 1.
    QUELL_LIVE Vector direction() {
        float const z = 1 - 2 * next(), r = sqrtf(larger(0, 1 - z * z));
        auto const around = turn_by(next());
        return {r * around.cosine, r * around.sine, z};
    }
};

} // namespace quell::live
