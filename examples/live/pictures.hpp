#pragma once

#include "core/vector.hpp"

#include <cstdint>

namespace quell::live {

/// What can be shown.
enum class Picture { noisy, denoised, reference };

/// A colour as it is shown: exposed, compressed towards white, and encoded for a screen, 0 to 1.
struct ToneMap {
    float exposure = 1; ///< factor

    [[nodiscard]] static float encoded(float a) {
        a *= 1 / (1 + a) * (1 + a * (1.f / 16)); // Reinhard's curve, white at 4
        a = a < 1 ? a : 1;
        float const root = sqrtf(a), fourth = sqrtf(root);
        return 0.585122381f * root + 0.783140355f * fourth - 0.368262736f * sqrtf(fourth); // near sRGB's curve
    }
    [[nodiscard]] Vector operator()(Vector a) const { return {encoded(a.x * exposure), encoded(a.y * exposure), encoded(a.z * exposure)}; }
};

/// A colour of 8 bits, opaque, as a canvas has it.
[[nodiscard]] inline uint32_t packed(Vector a) {
    auto const byte = [](float c) { return static_cast<uint32_t>(smaller(255, larger(0, c * 255 + 0.5f))); };
    return byte(a.x) | byte(a.y) << 8 | byte(a.z) << 16 | 0xff000000u;
}

/// The colour of an error from 0 to 1: black, violet, orange, yellow.
[[nodiscard]] inline Vector error_colour(float error) {
    constexpr Vector steps[] = {
        {0.02f, 0.02f, 0.06f}, {0.33f, 0.07f, 0.43f}, {0.73f, 0.22f, 0.33f}, {0.98f, 0.55f, 0.04f}, {0.99f, 1, 0.64f}};
    float const at = smaller(3.999f, larger(0, error) * 4);
    auto const step = static_cast<int>(at);
    return mix(steps[step], steps[step + 1], at - static_cast<float>(step));
}

} // namespace quell::live
