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

/// How far samples may be from a picture of them: noise of few bright samples is skewed.
struct ResidualLimits {
    float most = 20.f;    ///< samples are at most so many times the picture's luminance
    float dark = 0.02f;   ///< part of the image's mean luminance that is added to that
    float spike = 3.f;    ///< a residual is at most so many times the root mean square around; what is more is spread there
    int noise_radius = 3; ///< of the squares in which that is taken, in pixels
};

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

/// Samples minus picture.
struct PictureResidual {
    Extent size;
    std::vector<glm::vec3> value;    ///< 0 where there is no sample
    std::vector<double> mean_square; ///< of the pixels around, and of a hundredth of the picture's luminance; 0 where there is no sample

    PictureResidual(ResidualLimits const& limits, Extent size_, std::vector<glm::vec3> const& samples,
                    std::vector<glm::vec3> const& picture)
        : size(size_), value(samples.size(), glm::vec3(0.f)), mean_square(samples.size(), 0.) {
        auto const pixels = value.size();
        std::vector<double> bright(pixels), known(pixels);
        double sum = 0.;
        for (std::size_t i = 0; i < pixels; ++i) {
            float const luminance_here = luminance(vec3<float>(picture[i]));
            if (is_finite(luminance_here)) bright[i] = std::abs(static_cast<double>(luminance_here));
            sum += bright[i];
        }
        double const dark = static_cast<double>(limits.dark) * sum / static_cast<double>(pixels) + 1e-6;
        for (std::size_t i = 0; i < pixels; ++i) {
            bright[i] += dark;
            float const most = limits.most * static_cast<float>(bright[i]);
            glm::vec3 off(0.f);
            for (int c = 0; c < 3; ++c) off[c] = std::min(samples[i][c], most) - picture[i][c];
            if (is_light(vec3<float>(samples[i])) && all_finite(vec3<float>(off)))
                value[i] = off, mean_square[i] = product_of(off, off), known[i] = 1.;
        }
        auto const is_sample = known;
        box_sums(size, mean_square, limits.noise_radius), box_sums(size, known, limits.noise_radius);
        for (std::size_t i = 0; i < pixels; ++i)
            mean_square[i] = is_sample[i] > 0. ? mean_square[i] / known[i] + 1e-4 * bright[i] * bright[i] : 0.;
        for (std::size_t const half : {0u, 1u}) spread_spikes(limits, half);
    }
    /// Which half of the checkerboard a pixel is of.
    [[nodiscard]] std::size_t half_of(std::size_t pixel) const {
        auto const width = static_cast<std::size_t>(size.width);
        return (pixel / width + pixel % width) % 2;
    }
    /// Whether a pixel has a sample, and is of that half.
    [[nodiscard]] bool is_in(std::size_t half, std::size_t pixel) const { return mean_square[pixel] > 0. && half_of(pixel) == half; }

private:
    /// Noise of few bright samples is skewed. What a pixel has more than its surroundings is spread over pixels of its half, so that the
    /// mean stays and the halves know nothing of each other.
    void spread_spikes(ResidualLimits const& limits, std::size_t half) {
        auto const pixels = value.size();
        std::vector<double> count(pixels);
        std::array<std::vector<double>, 3> excess{count, count, count};
        for (std::size_t i = 0; i < pixels; ++i) {
            if (!is_in(half, i)) continue;
            count[i] = 1.;
            double const square = product_of(value[i], value[i]);
            double const limit = static_cast<double>(limits.spike) * static_cast<double>(limits.spike) * mean_square[i];
            if (!(square > limit)) continue;
            auto const kept = value[i] * static_cast<float>(std::sqrt(limit / square));
            for (int c = 0; c < 3; ++c) excess[static_cast<std::size_t>(c)][i] = static_cast<double>(value[i][c] - kept[c]);
            value[i] = kept;
        }
        box_sums(size, count, limits.noise_radius);
        for (int c = 0; c < 3; ++c) {
            auto& spread = excess[static_cast<std::size_t>(c)];
            box_sums(size, spread, limits.noise_radius);
            for (std::size_t i = 0; i < pixels; ++i)
                if (is_in(half, i)) value[i][c] += static_cast<float>(spread[i] / count[i]);
        }
    }
};

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
