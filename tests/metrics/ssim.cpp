#include "pictures.hpp"

#include <quell/metrics/ssim.hpp>

using namespace pictures;
using quell::metrics::ssim;

namespace {

double luminance(Picture const& picture, int x, int y) {
    x = std::clamp(x, 0, picture.size.width - 1);
    y = std::clamp(y, 0, picture.size.height - 1);
    auto const& p = picture.pixels[static_cast<std::size_t>(y * picture.size.width + x)];
    return 0.2126 * static_cast<double>(p.x) + 0.7152 * static_cast<double>(p.y) + 0.0722 * static_cast<double>(p.z);
}

/// The formulas as the paper states them: one window of 121 weights, variances as sums of squared differences from the mean, doubles.
double plain_ssim_at(Picture const& a, Picture const& b, int x, int y) {
    double weights[11][11], total = 0., mean_a = 0., mean_b = 0., variance_a = 0., variance_b = 0., covariance = 0.;
    for (int j = 0; j < 11; ++j)
        for (int i = 0; i < 11; ++i) total += weights[j][i] = std::exp(-((i - 5) * (i - 5) + (j - 5) * (j - 5)) / (2. * 1.5 * 1.5));
    auto const each = [&](auto f) {
        for (int j = 0; j < 11; ++j)
            for (int i = 0; i < 11; ++i) f(weights[j][i] / total, luminance(a, x + i - 5, y + j - 5), luminance(b, x + i - 5, y + j - 5));
    };
    each([&](double w, double p, double q) { mean_a += w * p, mean_b += w * q; });
    each([&](double w, double p, double q) {
        variance_a += w * (p - mean_a) * (p - mean_a);
        variance_b += w * (q - mean_b) * (q - mean_b);
        covariance += w * (p - mean_a) * (q - mean_b);
    });
    return (2. * mean_a * mean_b + 1e-4) * (2. * covariance + 9e-4) /
           ((mean_a * mean_a + mean_b * mean_b + 1e-4) * (variance_a + variance_b + 9e-4));
}

double plain_ssim(Picture const& a, Picture const& b, Mask const& mask) {
    double sum = 0.;
    int pixels = 0;
    for (int y = 0; y < a.size.height; ++y)
        for (int x = 0; x < a.size.width; ++x)
            if (mask.empty() || mask[static_cast<std::size_t>(y * a.size.width + x)] != 0) sum += plain_ssim_at(a, b, x, y), ++pixels;
    return sum / pixels;
}

} // namespace

TEST_CASE("ssim: agrees with the plain formulas at sizes above and below the window") {
    for (auto const size : {Extent{1, 1}, Extent{3, 17}, Extent{40, 4}, Extent{37, 45}, Extent{64, 33}}) {
        INFO(to_string(size));
        auto const a = scene(size);
        auto const mask = left_half(size);
        for (auto const& b : {disturbed(a, 0.02f, 5), disturbed(a, 0.4f, 5), noise(size, 6), constant(size, {0.9f, 0.1f, 0.4f})}) {
            CHECK(std::abs(ssim(a, b) - plain_ssim(a, b, {})) < 1e-9);
            if (size.width > 1) CHECK(std::abs(ssim(a, b, mask) - plain_ssim(a, b, mask)) < 1e-9);
        }
    }
}

TEST_CASE("ssim: 1 for equal pictures, symmetric, less for more noise") {
    auto const a = scene({50, 30}), b = disturbed(a, 0.1f, 3), c = disturbed(a, 0.4f, 3);
    CHECK(ssim(a, a) == doctest::Approx(1.).epsilon(1e-12));
    CHECK(ssim(a, b) == doctest::Approx(ssim(b, a)).epsilon(1e-12));
    CHECK(ssim(a, b) < 1.);
    CHECK(ssim(a, c) < ssim(a, b));
}

TEST_CASE("ssim: known value for two flat pictures") {
    auto const a = constant({20, 20}, glm::vec3(0.2f)), b = constant({20, 20}, glm::vec3(0.8f));
    CHECK(ssim(a, b) == doctest::Approx((2. * 0.2 * 0.8 + 1e-4) / (0.04 + 0.64 + 1e-4)).epsilon(1e-6));
}

TEST_CASE("ssim: refuses broken input") {
    refuses_broken_input([](auto const& a, auto const& b, auto const& mask) { return ssim(a, b, mask); });
}
