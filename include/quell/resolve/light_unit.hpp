#pragma once

#include <quell/core/value.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// The mean of a picture's luminance, whatever its sign.
/// @param picture row by row; what is not finite counts as black
inline double mean_brightness(std::vector<glm::vec3> const& picture) {
    double sum = 0.;
    for (auto const& pixel : picture)
        if (float const light = luminance(pixel); is_finite(light)) sum += static_cast<double>(abs(light));
    return sum / static_cast<double>(std::max<std::size_t>(picture.size(), 1));
}

/// The unit that a stage counts a picture's light in: a power of two, at most its mean brightness and more than half of that; 1 for a black
/// picture. Numbers of the stage then go with the picture, in whatever unit its light is, and dividing by a power of two rounds nothing.
/// @param mean brightness
inline float light_unit(double mean) {
    constexpr int farthest = 100; // so that no light that is any becomes 0 or infinite
    return mean > 0. ? std::ldexp(1.f, std::clamp(std::ilogb(mean), -farthest, farthest)) : 1.f;
}
/// The same.
/// @param picture row by row; what is not finite counts as black
inline float light_unit(std::vector<glm::vec3> const& picture) { return light_unit(mean_brightness(picture)); }

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
