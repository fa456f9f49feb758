#pragma once

#include "vector.hpp"

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

} // namespace quell::live
