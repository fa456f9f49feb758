#pragma once

#include <quell/core/real.hpp>
#include <quell/io/frame_image.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::io {

/// Sum of the light in three components over all pixels, each times its factor if there are factors. Values that are not finite count as 0.
[[nodiscard]] inline double light_sum(ExrImage const& image, std::vector<Source> const& light, std::vector<Source> const& factor = {}) {
    double sum = 0;
    for (std::size_t c = 0; c < light.size(); ++c) {
        auto const values = component_of(image, light[c]);
        auto const factors = factor.empty() ? std::vector<float>(values.size(), 1.f) : component_of(image, factor[c]);
        for (std::size_t i = 0; i < values.size(); ++i)
            if (is_finite(values[i]) && is_finite(factors[i])) sum += static_cast<double>(values[i]) * static_cast<double>(factors[i]);
    }
    return sum;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::io
