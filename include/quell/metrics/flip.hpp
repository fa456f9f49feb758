#pragma once

#include <quell/metrics/picture.hpp>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <numbers>

namespace quell::inline QUELL_INSTRUCTION_SET::metrics {

/// FLIP error per pixel: the difference that a viewer sees when the pictures alternate, from 0 (none) to 1.
struct Flip {
    Extent size;              ///< in pixels
    std::vector<float> error; ///< row by row from the top-left, in [0, 1]

    /// Mean over the pixels that count.
    /// @throws Error where the mask does not fit or selects nothing; also weighted_median
    [[nodiscard]] double mean(Mask const& mask = {}) const;
    /// Weighted median: the error below which the smaller errors make up half of the sum. Unlike the mean, it is not lowered by large
    /// correct areas.
    [[nodiscard]] double weighted_median(Mask const& mask = {}) const;
};

inline double Flip::mean(Mask const& mask) const {
    detail::check_size("FLIP error", size, error.size());
    return detail::mean_over(size, mask, [&](std::size_t i) { return static_cast<double>(error[i]); });
}

inline double Flip::weighted_median(Mask const& mask) const {
    detail::check_size("FLIP error", size, error.size());
    std::vector<float> sorted;
    double total = 0., sum = 0.;
    detail::for_each_selected(size, mask, [&](std::size_t i) { total += sorted.emplace_back(error[i]); });
    std::ranges::sort(sorted);
    auto const half = std::ranges::find_if(sorted, [&](float e) { return (sum += e) > 0.5 * total; });
    return half == sorted.end() ? 0. : static_cast<double>(*half);
}

namespace detail {

/// CIE XYZ relative to sRGB's white, so that white is (1, 1, 1), and its inverse. From the published sRGB matrix.
struct RelativeXyz {
    glm::mat3 from_rgb, to_rgb;
};
inline RelativeXyz relative_xyz() {
    // Columns: the XYZ of the red, green and blue primary.
    glm::dmat3 const primaries{
        {0.4123907993, 0.2126390059, 0.0193308187}, {0.3575843394, 0.7151686788, 0.1191947798}, {0.1804807884, 0.0721923154, 0.9505321522}};
    auto const white = primaries * glm::dvec3(1.);
    auto const relative = glm::dmat3{primaries[0] / white, primaries[1] / white, primaries[2] / white};
    return {glm::mat3(relative), glm::mat3(glm::inverse(relative))};
}

/// YCxCz opponent colours of FLIP section 4.1 without scale and offset: y, x - y, y - z of relative XYZ. The filters are linear with
/// weights of sum 1, so scaling would cancel out.
struct Opponent {
    Plane<float> achromatic, red_green, blue_yellow;
};
inline Opponent opponent(Picture const& displayed) {
    auto const from_rgb = relative_xyz().from_rgb;
    std::vector<float> const none(displayed.pixels.size());
    Opponent result{{displayed.size, none}, {displayed.size, none}, {displayed.size, none}};
    for (std::size_t i = 0; i < none.size(); ++i) {
        auto const& p = displayed.pixels[i];
        auto const xyz = from_rgb * glm::vec3(linear_from_srgb(p.x), linear_from_srgb(p.y), linear_from_srgb(p.z));
        result.achromatic.values[i] = xyz.y;
        result.red_green.values[i] = xyz.x - xyz.y;
        result.blue_yellow.values[i] = xyz.y - xyz.z;
    }
    return result;
}

/// One Gaussian term a * sqrt(pi / b) * exp(-pi^2 x^2 / b) of a contrast sensitivity function, x in degrees.
struct Sensitivity {
    double a, b;
};
// FLIP table 1. The first two functions have a single term.
inline constexpr Sensitivity achromatic_sensitivity{1., 0.0047}, red_green_sensitivity{1., 0.0053};
inline constexpr Sensitivity blue_yellow_sensitivity[2] = {{34.1, 0.04}, {13.5, 0.025}};

inline double deviation_in_pixels(Sensitivity s, double pixels_per_degree) {
    return std::sqrt(s.b / 2.) / std::numbers::pi * pixels_per_degree;
}

/// Taps of the term. FLIP gives all terms the window of the widest, 3 of its deviations; beyond 6 of a term's own, its taps are 0.
inline Taps<float> sensitivity_taps(Sensitivity s, double pixels_per_degree) {
    auto const window = std::ceil(3. * deviation_in_pixels(blue_yellow_sensitivity[0], pixels_per_degree));
    auto const deviation = deviation_in_pixels(s, pixels_per_degree);
    return gaussian<float>(deviation, static_cast<int>(std::min(window, std::ceil(6. * deviation))));
}

inline Plane<float> perceived(Plane<float> const& plane, Sensitivity s, double pixels_per_degree) {
    auto const taps = sensitivity_taps(s, pixels_per_degree);
    return along_columns(along_rows(plane, taps), taps);
}

/// A sum of two Gaussians is not separable, but each one is. Their shares are their sums over the window.
inline Plane<float> perceived_blue_yellow(Plane<float> const& plane, double pixels_per_degree) {
    auto const integral = [&](Sensitivity s) {
        auto const taps = sensitivity_taps(s, pixels_per_degree);
        auto const width = 1. / static_cast<double>(taps[taps.size() / 2]); // their sum before normalisation
        return s.a * std::sqrt(std::numbers::pi / s.b) * width * width;
    };
    auto const [first, second] = blue_yellow_sensitivity;
    auto const share = static_cast<float>(integral(first) / (integral(first) + integral(second)));
    auto result = perceived(plane, first, pixels_per_degree);
    auto const other = perceived(plane, second, pixels_per_degree);
    std::ranges::transform(result.values, other.values, result.values.begin(), [=](float a, float b) { return b + (a - b) * share; });
    return result;
}

/// CIE L*a*b* of relative XYZ, with a* and b* scaled by L*: saturation matters less in the dark (Hunt effect, FLIP section 4.1).
inline glm::vec3 hunt_adjusted_lab(glm::vec3 const& xyz) {
    constexpr float limit = 6.f / 29.f;
    // std::pow is three times as fast as std::cbrt in glibc.
    auto const f = [](float t) { return t > limit * limit * limit ? std::pow(t, 1.f / 3.f) : t / (3.f * limit * limit) + 4.f / 29.f; };
    auto const x = f(xyz.x), y = f(xyz.y), z = f(xyz.z), lightness = 116.f * y - 16.f;
    return {lightness, 0.01f * lightness * 500.f * (x - y), 0.01f * lightness * 200.f * (y - z)};
}

/// The picture as an eye at this distance resolves it, in Hunt-adjusted L*a*b*.
inline Picture perceived_lab(Extent size, Opponent const& colours, double pixels_per_degree) {
    auto const space = relative_xyz();
    auto const achromatic = perceived(colours.achromatic, achromatic_sensitivity, pixels_per_degree);
    auto const red_green = perceived(colours.red_green, red_green_sensitivity, pixels_per_degree);
    auto const blue_yellow = perceived_blue_yellow(colours.blue_yellow, pixels_per_degree);
    Picture result{size, std::vector<glm::vec3>(count(size))};
    for (std::size_t i = 0; i < result.pixels.size(); ++i) {
        auto const y = achromatic.values[i];
        auto const rgb = space.to_rgb * glm::vec3(red_green.values[i] + y, y, y - blue_yellow.values[i]);
        // Channels are blurred differently, so colours may leave the gamut.
        glm::vec3 const shown(std::clamp(rgb.x, 0.f, 1.f), std::clamp(rgb.y, 0.f, 1.f), std::clamp(rgb.z, 0.f, 1.f));
        result.pixels[i] = hunt_adjusted_lab(space.from_rgb * shown);
    }
    return result;
}

/// HyAB distance (city block in lightness, Euclidean in chroma) to the power 0.7: FLIP section 4.1.
inline float colour_distance(glm::vec3 const& a, glm::vec3 const& b) {
    auto const d = a - b;
    return std::pow(std::abs(d.x) + std::sqrt(d.y * d.y + d.z * d.z), 0.7f);
}

/// Maps distances to [0, 1]: those up to 0.4 of the largest (pure green against pure blue) fill [0, 0.95].
inline float colour_error(float distance, float largest) {
    auto const knee = 0.4f * largest;
    return distance < knee ? distance * (0.95f / knee) : 0.95f + (distance - knee) / (largest - knee) * 0.05f;
}

/// Strength of edges and of points (lines, dots) per pixel.
struct Features {
    Plane<float> edges, points;
};

/// Feature filters: a Gaussian and its first two derivatives. Positive weights sum to 1, negative ones to -1.
struct FeatureTaps {
    Taps<float> smooth, first, second;
};
inline FeatureTaps feature_taps(double pixels_per_degree) {
    // FLIP section 4.2: an edge is seen across 0.082 degrees.
    auto const deviation = 0.5 * 0.082 * pixels_per_degree;
    auto const radius = static_cast<int>(std::ceil(3. * deviation));
    auto const derivative = [&](auto factor) {
        std::vector<double> weights;
        double positive = 0., negative = 0.;
        for (int x = -radius; x <= radius; ++x) {
            auto const weight = weights.emplace_back(factor(x / deviation) * std::exp(-0.5 * (x / deviation) * (x / deviation)));
            (weight > 0. ? positive : negative) += std::abs(weight);
        }
        Taps<float> taps;
        for (auto const weight : weights) taps.push_back(static_cast<float>(weight / (weight > 0. ? positive : negative)));
        return taps;
    };
    return {gaussian<float>(deviation, radius), derivative([](double x) { return -x; }), derivative([](double x) { return x * x - 1.; })};
}

inline Plane<float> length_of(Plane<float> x, Plane<float> const& y) {
    std::ranges::transform(x.values, y.values, x.values.begin(), [](float a, float b) { return std::sqrt(a * a + b * b); });
    return x;
}
inline Features features(Plane<float> const& luminance, FeatureTaps const& taps) {
    auto const smooth = along_rows(luminance, taps.smooth);
    return {length_of(along_columns(along_rows(luminance, taps.first), taps.smooth), along_columns(smooth, taps.first)),
            length_of(along_columns(along_rows(luminance, taps.second), taps.smooth), along_columns(smooth, taps.second))};
}

/// Feature difference of FLIP section 4.2: the stronger of the two, over its maximum, to the power 1/2.
inline float feature_error(Features const& a, Features const& b, std::size_t i) {
    auto const edges = std::abs(a.edges.values[i] - b.edges.values[i]), points = std::abs(a.points.values[i] - b.points.values[i]);
    return std::sqrt(std::max(edges, points) / std::numbers::sqrt2_v<float>);
}

} // namespace detail

/// LDR-FLIP: Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström, Fairchild 2020, "FLIP: A Difference Evaluator for Alternating Images".
/// Beyond the border the nearest pixel is repeated.
/// @param reference a displayed picture
/// @param test a displayed picture of the same size
/// @param pixels_per_degree of the viewer, 1 to 10000. 67: a 0.7 m wide monitor of 3840 pixels seen from 0.7 m
/// @throws Error where sizes differ, a component is outside [0, 1], or pixels_per_degree is outside its range
[[nodiscard]] inline Flip flip(Picture const& reference, Picture const& test, float pixels_per_degree = 67.f) {
    using namespace detail;
    check_pair(reference, test);
    // Below 1 a filter is narrower than a pixel and has no derivative. Comparing bits also rejects NaN.
    if (auto const bits = std::bit_cast<std::uint32_t>(pixels_per_degree); bits < 0x3f800000u || bits > 0x461c4000u)
        raise_error("FLIP", std::to_string(pixels_per_degree) + " pixels per degree",
                    "give it 1 to 10000; a monitor at arm's length has 67");
    auto const a = opponent(reference), b = opponent(test);
    auto const lab_a = perceived_lab(reference.size, a, pixels_per_degree), lab_b = perceived_lab(test.size, b, pixels_per_degree);
    auto const taps = feature_taps(pixels_per_degree);
    auto const features_a = features(a.achromatic, taps), features_b = features(b.achromatic, taps);
    auto const from_rgb = relative_xyz().from_rgb;
    auto const largest = colour_distance(hunt_adjusted_lab(from_rgb[1]), hunt_adjusted_lab(from_rgb[2]));
    Flip result{reference.size, std::vector<float>(reference.pixels.size())};
    for (std::size_t i = 0; i < result.error.size(); ++i) {
        auto const colour = colour_error(colour_distance(lab_a.pixels[i], lab_b.pixels[i]), largest);
        // Rounding may exceed 1.
        result.error[i] = std::min(std::pow(colour, 1.f - feature_error(features_a, features_b, i)), 1.f);
    }
    return result;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::metrics
