#pragma once

#include <quell/metrics/picture.hpp>

#include <glm/geometric.hpp>

#include <functional>

namespace quell::inline QUELL_INSTRUCTION_SET::metrics {

namespace detail {

/// Luminance of a displayed colour: Rec. 709 weights on the encoded components.
inline Plane<double> luminance(Picture const& picture) {
    Plane<double> result{picture.size, {}};
    result.values.reserve(picture.pixels.size());
    for (auto const& p : picture.pixels) result.values.push_back(glm::dot(glm::dvec3(p), {0.2126, 0.7152, 0.0722}));
    return result;
}

/// Local means with a window of 11x11 Gaussian weights.
inline Plane<double> local_mean(Plane<double> const& plane) {
    auto const window = gaussian<double>(1.5, 5);
    return along_columns(along_rows(plane, window), window);
}
inline Plane<double> local_mean_of_product(Plane<double> a, Plane<double> const& b) {
    std::ranges::transform(a.values, b.values, a.values.begin(), std::multiplies{});
    return local_mean(a);
}

/// Luminance and contrast-structure terms of Wang et al. 2004, eq. 13, from local means and second moments.
inline double similarity(double mean_a, double mean_b, double variance_a, double variance_b, double covariance) {
    constexpr double c1 = 0.01 * 0.01, c2 = 0.03 * 0.03;
    return (2. * mean_a * mean_b + c1) * (2. * covariance + c2) /
           ((mean_a * mean_a + mean_b * mean_b + c1) * (variance_a + variance_b + c2));
}

} // namespace detail

/// Mean structural similarity of luminance: 1 if equal, at least -1. Wang, Bovik, Sheikh, Simoncelli 2004, "Image quality assessment: from
/// error visibility to structural similarity", with their 11x11 Gaussian window of deviation 1.5, K1 = 0.01, K2 = 0.03. The border repeats,
/// so that every pixel counts, a mask may select any, and a picture may be smaller than the window. (Wang's program leaves out a border of
/// 5 pixels instead.)
/// @throws Error where sizes differ, a component is outside [0, 1], or the mask does not fit or selects nothing
[[nodiscard]] inline double ssim(Picture const& reference, Picture const& test, Mask const& mask = {}) {
    using namespace detail;
    check_pair(reference, test);
    auto const a = luminance(reference), b = luminance(test);
    auto const mean_a = local_mean(a), mean_b = local_mean(b);
    auto const aa = local_mean_of_product(a, a), bb = local_mean_of_product(b, b), ab = local_mean_of_product(a, b);
    return mean_over(reference.size, mask, [&](std::size_t i) {
        auto const x = mean_a.values[i], y = mean_b.values[i];
        return similarity(x, y, aa.values[i] - x * x, bb.values[i] - y * y, ab.values[i] - x * y);
    });
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::metrics
