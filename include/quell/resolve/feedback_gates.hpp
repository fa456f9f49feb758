#pragma once

#include <quell/resolve/logarithm.hpp>
#include <quell/resolve/picture_residual.hpp>
#include <quell/resolve/residual_levels.hpp>
#include <quell/resolve/window_sums.hpp>

#include <array>

/// What the shares of ResidualFeedback depend on.
namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// What the shares of each pixel depend on.
struct FeedbackGates {
    Planes<1> light;           ///< around the pixel
    Planes<1> light_logarithm; ///< of the pixel's own light, which edges of light are found in
    Planes<1> variance;        ///< of the samples, of one component
    Planes<1> noise;           ///< N of ResidualFeedbackShares
    Planes<1> texture;         ///< how much light varies around the pixel: twice its logarithm's standard deviation, to 1.5

    template <Executor E>
    FeedbackGates(E const& executor, WindowSums<4>& sums, PictureResidual const& residual, PlanesView<3> picture,
                  Brightness const& brightness)
        : light(light_around(executor, sums, brightness)), light_logarithm(residual.size), variance(residual.size), noise(residual.size),
          texture(residual.size) {
        auto const size = residual.size;
        auto const square = residual.mean_square.view(), spread = variance.view(), around_light = light.view(),
                   logarithms = light_logarithm.view(), noises = noise.view(), textures = texture.view();
        constexpr int of_variance = 2, of_missing = 3, of_texture = 4;
        // Where there is no sample, noise is that of the samples around.
        sums.around<1>(
            executor, of_missing, [=]<class Real>(AtOnce<Real>, int x, int y) { return std::array{load_pixels<Real>(square, x, y)}; },
            [=]<class Real>(AtOnce<Real>, int x, int y, int count, auto const& around) {
                auto const own = load_pixels<Real>(square, x, y);
                store_pixels<Real>(spread, x, y, select(own > Real(0.f), own, around[0] / pixels_in_square<Real>(x, y, of_missing, size)),
                                   count);
            });
        float const log_mean = logarithm(brightness.mean + brightness.dark(0.f));
        sums.around<1>(
            executor, of_variance, [=]<class Real>(AtOnce<Real>, int x, int y) { return std::array{load_pixels<Real>(spread, x, y)}; },
            [=]<class Real>(AtOnce<Real>, int x, int y, int count, auto const& around) {
                auto const its_light = load_pixels<Real>(around_light, x, y);
                auto const its = max(around[0] / pixels_in_square<Real>(x, y, of_variance, size) / 3.f, Real(1e-20f));
                store_pixels<Real>(spread, x, y, its, count);
                auto const logarithm_of_noise = logarithm(sqrt(its) / its_light + 1e-3f) * 1.44269504f; // to the base of 2
                store_pixels<Real>(noises, x, y, clamp(logarithm_of_noise / 3.f, Real(-2.f), Real(1.5f)), count);
                auto const own = luminance(load_pixels<Real>(picture, x, y));
                auto const positive = masked(is_finite(own), max(own, Real(0.f)));
                store_pixels<Real>(logarithms, x, y, logarithm(fma(its_light, Real(.05f), positive)), count);
            });
        sums.around<2>(
            executor, of_texture,
            [=]<class Real>(AtOnce<Real>, int x, int y) {
                auto const its = logarithm(load_pixels<Real>(around_light, x, y)) - log_mean;
                return std::array{its, its * its};
            },
            [=]<class Real>(AtOnce<Real>, int x, int y, int count, auto const& around) {
                auto const per_pixels = 1.f / pixels_in_square<Real>(x, y, of_texture, size), mean = around[0] * per_pixels;
                auto const varies = max(fma(around[1], per_pixels, -(mean * mean)), Real(0.f));
                store_pixels<Real>(textures, x, y, min(2.f * sqrt(varies), Real(1.5f)), count);
            });
    }
};

/// What samples that were held out say of a band: the share of it that is there, and how sure that is, from 0 to 1.
template <Executor E>
Planes<2> held_shares(E const& executor, WindowSums<4>& sums, PictureResidual const& residual, ResidualLevel const& fine,
                      ResidualLevel const& coarse) {
    Planes<2> shares(residual.size);
    auto const off = residual.value.view(), finer = fine.held.view(), coarser = coarse.held.view();
    auto const square = residual.mean_square.view();
    auto const to = shares.view();
    sums.around<3>(
        executor, 6,
        [=]<class Real>(AtOnce<Real>, int x, int y) {
            auto const mean = load_pixels<Real>(square, x, y);
            auto const per_square = masked(mean > Real(0.f), 1.f / max(mean, Real(1e-37f)));
            auto const band = load_pixels<Real>(finer, x, y) - load_pixels<Real>(coarser, x, y);
            auto const product = dot(load_pixels<Real>(off, x, y), band) * per_square;
            return std::array{product, dot(band, band) * per_square, product * product};
        },
        [=]<class Real>(AtOnce<Real>, int x, int y, int count, auto const& around) {
            auto const deviation = sqrt(fma(around[2], Real(2.f), Real(1e-20f)));
            store_pixels<Real>(to, x, y,
                               {clamp(around[0] / max(around[1], Real(1e-12f)), Real(0.f), Real(1.f)),
                                clamp(around[0] / deviation / 3.f, Real(0.f), Real(1.f))},
                               count);
        });
    return shares;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
