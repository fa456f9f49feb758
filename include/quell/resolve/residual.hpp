#pragma once

#include <quell/core/error.hpp>
#include <quell/core/light.hpp>
#include <quell/resolve/box_sums.hpp>

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {

/// Their dot product.
inline double product_of(glm::vec3 const& a, glm::vec3 const& b) {
    double sum = 0.;
    for (int c = 0; c < 3; ++c) sum += static_cast<double>(a[c]) * static_cast<double>(b[c]);
    return sum;
}

/// Means over the square around each pixel, as far as it lies in the image.
inline std::vector<double> box_means(Extent size, std::vector<double> values, int radius) {
    box_sums(size, values, radius);
    std::size_t i = 0;
    for (int y = 0; y < size.height; ++y) {
        int const rows = std::min(y + radius + 1, size.height) - std::max(y - radius, 0);
        for (int x = 0; x < size.width; ++x, ++i)
            values[i] /= static_cast<double>(rows * (std::min(x + radius + 1, size.width) - std::max(x - radius, 0)));
    }
    return values;
}

/// The light of a picture around each pixel, and a little of that of the whole picture.
inline std::vector<double> light_around(Extent size, std::vector<glm::vec3> const& picture) {
    std::vector<double> light(picture.size());
    double sum = 0.;
    for (std::size_t i = 0; i < light.size(); ++i) {
        float const here = luminance(vec3<float>(picture[i]));
        if (is_finite(here)) light[i] = std::abs(static_cast<double>(here));
        sum += light[i];
    }
    double const dark = .02 * sum / static_cast<double>(light.size()) + 1e-6;
    light = box_means(size, std::move(light), 2);
    for (auto& each : light) each += dark;
    return light;
}

/// @param what function the images were given to
/// @throws Error where they differ in size
inline void check_residual_sizes(std::string const& what, std::vector<glm::vec3> const& samples, Extent normal, Extent depth,
                                 std::vector<glm::vec3> const& picture) {
    if (!(normal == depth))
        raise_error(what + ": the normals", to_string(normal) + " beside depths of " + to_string(depth), "give both the picture's size");
    auto const pixels = static_cast<std::size_t>(depth.pixels());
    for (auto const& [image, count] : {std::pair{": the samples", samples.size()}, std::pair{": the picture", picture.size()}})
        if (count != pixels)
            raise_error(what + image, std::to_string(count) + " pixels beside depths of " + to_string(depth),
                        "give one value for each pixel, row by row");
}

} // namespace detail

} // namespace quell::inline QUELL_INSTRUCTION_SET
