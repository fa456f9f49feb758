#pragma once

#include <quell/core/light.hpp>
#include <quell/resolve/residual_bands.hpp>
#include <quell/resolve/residual_feedback_fit.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Gives back to a denoised picture what its filter took out by mistake, by shares that were fitted to renders: see
/// ResidualFeedbackShares. It does what Twicing does, at any number of samples, and without a test that has to be sure.
///
/// The residual, samples minus picture, is smoothed over surfaces and over pieces of like light, in four levels with steps of 1, 2, 4 and 8
/// pixels. A part of the finest level, of the widest one, of two bands between levels, and of the residual itself is added. How much
/// depends on the noise, on the light's texture, on how far the level is more than that noise would leave, and on what samples that were
/// held out by a checkerboard have in common with the band (as in Twicing). The picture also moves away from the estimate of the frame
/// alone: windows that choose between it and history (Evidence) trust history too little.
struct ResidualFeedback {
    float samples = 1.f;                            ///< of each pixel; shares lie between those of 1 and of 16
    std::optional<ResidualFeedbackShares> shares{}; ///< others; none: those that were fitted for `samples`
    float depth_range = 0.05f;                      ///< part by which depths of one surface differ
    float light_range = 0.15f;                      ///< by how much the logarithm of one piece of light differs
    float most = 3.f;                               ///< what is added of each part is at most so many times the light around
    float darkest = 0.2f;                           ///< of the picture's light so much stays at least
    ResidualLimits limits{};                        ///< of the residual
};

namespace detail {

inline constexpr int feedback_levels = 4; ///< of 1, 2, 4 and 8 pixels

/// What the shares of each pixel depend on.
struct FeedbackGates {
    std::vector<double> light;    ///< around the pixel
    std::vector<double> variance; ///< of the samples, of one component
    std::vector<double> noise;    ///< N of ResidualFeedbackShares
    std::vector<double> texture;  ///< how much light varies around the pixel: twice its logarithm's standard deviation, to 1.5

    FeedbackGates(PictureResidual const& residual, std::vector<glm::vec3> const& picture) {
        auto const size = residual.size;
        auto const pixels = picture.size();
        light = light_around(size, picture);
        // Where there is no sample, noise is that of the samples around.
        auto squares = residual.mean_square;
        auto const around = box_means(size, squares, 3);
        for (std::size_t i = 0; i < pixels; ++i)
            if (!(squares[i] > 0.)) squares[i] = around[i];
        variance = box_means(size, squares, 2);
        for (auto& each : variance) each = std::max(each / 3., 1e-20);
        noise.resize(pixels);
        for (std::size_t i = 0; i < pixels; ++i) noise[i] = std::clamp(std::log2(std::sqrt(variance[i]) / light[i] + 1e-3) / 3., -2., 1.5);
        std::vector<double> logarithm(pixels), squared(pixels);
        for (std::size_t i = 0; i < pixels; ++i) logarithm[i] = std::log(light[i]), squared[i] = logarithm[i] * logarithm[i];
        auto const mean = box_means(size, logarithm, 4);
        texture = box_means(size, squared, 4);
        for (std::size_t i = 0; i < pixels; ++i) texture[i] = std::min(2. * std::sqrt(std::max(texture[i] - mean[i] * mean[i], 0.)), 1.5);
    }
};

/// How far the finest level is more than noise: 0 to 1.
inline std::vector<double> sureness(Extent size, ResidualBand const& level, std::vector<double> const& variance) {
    constexpr double noise_left = .27; // of the noise's standard deviation, by the spline's weights
    constexpr int radius = 2;
    std::vector<double> square(variance.size()), noise(variance.size());
    for (std::size_t i = 0; i < square.size(); ++i)
        square[i] = product_of(level.value[i], level.value[i]) / 3., noise[i] = noise_left * noise_left * variance[i] + 1e-20;
    box_sums(size, square, radius), box_sums(size, noise, radius);
    for (std::size_t i = 0; i < square.size(); ++i) square[i] /= square[i] + 4. * noise[i];
    return square;
}

/// What samples that were held out say of a band: the share of it that is there, and how sure that is, from 0 to 1.
struct HeldShares {
    std::vector<double> share, sure;

    HeldShares(PictureResidual const& residual, std::vector<glm::vec3> const& fine, std::vector<glm::vec3> const& coarse)
        : share(fine.size()), sure(fine.size()) {
        constexpr int radius = 6;
        std::vector<double> square(fine.size());
        for (std::size_t i = 0; i < share.size(); ++i) {
            if (!(residual.mean_square[i] > 0.)) continue;
            auto const band = fine[i] - coarse[i];
            share[i] = product_of(residual.value[i], band) / residual.mean_square[i];
            square[i] = product_of(band, band) / residual.mean_square[i], sure[i] = share[i] * share[i];
        }
        for (auto* const each : {&share, &square, &sure}) box_sums(residual.size, *each, radius);
        for (std::size_t i = 0; i < share.size(); ++i) {
            sure[i] = std::clamp(share[i] / std::sqrt(2. * sure[i] + 1e-20) / 3., 0., 1.);
            share[i] = std::clamp(share[i] / std::max(square[i], 1e-12), 0., 1.);
        }
    }
};

/// The logarithm of a picture's light, which edges of light are found in.
inline ImageOf<Planar<>, Depth> logarithm_of_light(Extent size, std::vector<glm::vec3> const& picture, std::vector<double> const& light) {
    ImageOf<Planar<>, Depth> image(size);
    std::size_t i = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x, ++i) {
            float const here = luminance(vec3<float>(picture[i]));
            image.view().set(0, x, y, std::log(std::max(is_finite(here) ? here : 0.f, 0.f) + .05f * static_cast<float>(light[i])));
        }
    return image;
}

} // namespace detail

/// Adds to a picture what its samples tell that it lacks (ResidualFeedback).
/// @param rule     how
/// @param executor runs the passes
/// @param samples  that the picture was made of, linear, row by row; not finite where there is none
/// @param normal   a view of the surfaces' directions, of any length; zero: none
/// @param depth    a view of their distances; infinite: none
/// @param alone    the same frame denoised by itself; the picture again where it has no history
/// @param picture  the denoised one; is changed
/// @throws Error where these are not of one size, std::bad_alloc
template <Executor E>
void feed_back_residual(ResidualFeedback const& rule, E const& executor, std::vector<glm::vec3> const& samples,
                        ViewOf<Planar<>, Normal> normal, ViewOf<Planar<>, Depth> depth, std::vector<glm::vec3> const& alone,
                        std::vector<glm::vec3>& picture) {
    using namespace detail;
    check_residual_sizes("feed_back_residual", samples, normal.size, depth.size, picture);
    check_residual_sizes("feed_back_residual, alone", alone, normal.size, depth.size, picture);
    auto const size = depth.size;
    PictureResidual const residual(rule.limits, size, samples, picture);
    FeedbackGates const gates(residual, picture);
    auto const light = logarithm_of_light(size, picture, gates.light);
    auto const levels = levels_of<feedback_levels>(executor, residual, {normal, depth, rule.depth_range, light.view(), rule.light_range});
    auto const sure = sureness(size, levels[0], gates.variance);
    HeldShares const fine(residual, levels[0].held, levels[1].held), middle(residual, levels[2].held, levels[3].held);
    auto const by = rule.shares.value_or(ResidualFeedbackShares::of_samples(rule.samples));
    for (std::size_t i = 0; i < picture.size(); ++i) {
        if (!all_finite(vec3<float>(picture[i]))) continue;
        auto const number = [](double value) { return static_cast<float>(value); };
        float const n = number(gates.noise[i]), most = rule.most * number(gates.light[i]);
        glm::vec3 off(0.f);
        auto const add = [&](float share, glm::vec3 const& part) {
            for (int c = 0; c < 3; ++c)
                if (is_finite(part[c])) off[c] += share * std::clamp(part[c], -most, most);
        };
        // No frequency is fed back more than whole, however many parts have it.
        float const own = std::clamp(by.sample + by.sample_noise * n, 0.f, 1.f);
        float const finest_share =
            std::min((by.near_noise + by.near_sure * number(sure[i]) + by.near_held * number(fine.share[i])) * n, 1.f - own);
        float const left = 1.f - own - std::max(finest_share, 0.f);
        auto const& finest = levels[0].value[i];
        add(own, residual.value[i]);
        add(finest_share, finest);
        add(std::min(by.fine_held * number(fine.share[i] * fine.sure[i]), left), finest - levels[1].value[i]);
        add(std::min(by.middle_held * number(middle.share[i] * middle.sure[i]), left), levels[2].value[i] - levels[3].value[i]);
        add(std::min(by.wide + by.wide_noise * n + by.wide_texture * number(gates.texture[i]), left), levels[3].value[i]);
        add(by.alone, alone[i] - picture[i]);
        for (int c = 0; c < 3; ++c) {
            float const before = picture[i][c];
            picture[i][c] = std::max(before + off[c], std::min(before, rule.darkest * before));
        }
    }
}

} // namespace quell::inline QUELL_INSTRUCTION_SET
