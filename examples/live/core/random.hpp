#pragma once

#include "vector.hpp"

#include <stdint.h>

namespace quell::live {

/// Sine and cosine of an angle.
struct Turn {
    float sine = 0, cosine = 1;
};

/// Of a part of a whole turn, 0 to 1, to within 5e-7: Taylor's polynomials about the nearest quarter. sinf() and cosf() take any angle, and
/// longer for it, above all as WebAssembly.
QUELL_LIVE Turn turn_by(float part) {
    float const quarters = floorf(4 * part + 0.5f);
    float const a = 2 * pi * (part - 0.25f * quarters), a2 = a * a;
    float const sine = a * (1 + a2 * (-1 / 6.f + a2 * (1 / 120.f + a2 * (-1 / 5040.f))));
    float const cosine = 1 + a2 * (-1 / 2.f + a2 * (1 / 24.f + a2 * (-1 / 720.f + a2 * (1 / 40320.f))));
    int const quarter = static_cast<int>(quarters);
    bool const is_across = quarter % 2 != 0;
    float const first = is_across ? cosine : sine, second = is_across ? sine : cosine;
    return {quarter % 4 >= 2 ? -first : first, quarter % 4 == 1 || quarter % 4 == 2 ? -second : second};
}

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
