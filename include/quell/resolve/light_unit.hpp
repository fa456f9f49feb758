#pragma once

#include <quell/core/value.hpp>
#include <quell/image/image_storage.hpp>

#include <algorithm>
#include <cmath>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// The mean of a picture's luminance, whatever its sign.
/// @param picture a view of three components; what is not finite counts as black
inline double mean_brightness(ImageView auto const& picture) {
    double sum = 0.;
    for (int y = 0; y < picture.size.height; ++y)
        for (int x = 0; x < picture.size.width; ++x) {
            float const light = luminance(glm::vec3(picture.get(0, x, y), picture.get(1, x, y), picture.get(2, x, y)));
            if (is_finite(light)) sum += static_cast<double>(abs(light));
        }
    return sum / static_cast<double>(std::max<long long>(picture.size.pixels(), 1));
}

/// The unit that a stage counts a picture's light in: a power of two, at most its mean brightness and more than half of that; 1 for a black
/// picture. Numbers of the stage then go with the picture, in whatever unit its light is, and dividing by a power of two rounds nothing.
/// @param mean brightness
inline float light_unit(double mean) {
    constexpr int farthest = 100; // so that no light that is any becomes 0 or infinite
    return mean > 0. ? std::ldexp(1.f, std::clamp(std::ilogb(mean), -farthest, farthest)) : 1.f;
}
/// The same.
/// @param picture a view of three components; what is not finite counts as black
inline float light_unit(ImageView auto const& picture) { return light_unit(mean_brightness(picture)); }

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
