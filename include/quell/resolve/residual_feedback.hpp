#pragma once

#include <quell/resolve/logarithm.hpp>
#include <quell/resolve/residual_feedback_fit.hpp>
#include <quell/resolve/residual_levels.hpp>
#include <quell/resolve/residual_sizes.hpp>
#include <quell/resolve/shared_noise.hpp>
#include <quell/resolve/window_sums.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Gives back to a denoised picture what its filter took out by mistake, by shares that were fitted to renders: see
/// ResidualFeedbackShares. It is a kind of twicing (Tukey 1977, "Exploratory Data Analysis").
///
/// The residual, samples minus picture, is smoothed over surfaces and over pieces of like light, in four levels with steps of 1, 2, 4 and 8
/// pixels. A part of the finest level, of the widest one, of two bands between levels, and of the residual itself is added. How much
/// depends on the noise, on the light's texture, on how far the level is more than that noise would leave, and on what samples that were
/// held out have in common with the band: with B the band at even pixels, made of the residual r at odd ones, and the other way round as on
/// a checkerboard, sum r B / sum B^2 over a window. The picture also moves away from the estimate of the frame alone: windows that choose
/// between it and history (Evidence) trust history too little.
struct ResidualFeedback {
    float samples = 1.f;                            ///< of each pixel; shares lie between those of 1 and of 16
    std::optional<ResidualFeedbackShares> shares{}; ///< others; none: those that were fitted for `samples`
    float depth_range = 0.05f;                      ///< part by which depths of one surface differ
    float light_range = 0.15f;                      ///< by how much the logarithm of one piece of light differs
    float most = 3.f;                               ///< what is added of each part is at most so many times the light around
    float darkest = 0.2f;                           ///< of the picture's light so much stays at least
    ResidualLimits limits{};                        ///< of the residual
    SharedNoise of_neighbours{};                    ///< where neighbours share their noise, less is added, or nothing
};

namespace detail {

inline constexpr int feedback_levels = 4; ///< of 1, 2, 4 and 8 pixels

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

/// How far the finest level is more than noise: 0 to 1.
template <Executor E> Planes<1> sureness(E const& executor, WindowSums<4>& sums, ResidualLevel const& finest, Planes<1> const& variance) {
    constexpr float noise_left = .27f; // of the noise's standard deviation, by the spline's weights
    Planes<1> sure(variance.size());
    auto const level = finest.value.view();
    auto const of_samples = variance.view(), to = sure.view();
    sums.around<2>(
        executor, 2,
        [=]<class Real>(AtOnce<Real>, int x, int y) {
            auto const value = load_pixels<Real>(level, x, y);
            return std::array{dot(value, value) / 3.f,
                              fma(load_pixels<Real>(of_samples, x, y), Real(noise_left * noise_left), Real(1e-20f))};
        },
        [=]<class Real>(AtOnce<Real>, int x, int y, int count, auto const& around) {
            store_pixels<Real>(to, x, y, around[0] / fma(around[1], Real(4.f), around[0]), count);
        });
    return sure;
}

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

/// Adds to each pixel its shares of the parts of a residual.
struct FeedBack {
    static constexpr auto name = "feed back";
    ResidualFeedbackShares by;
    float trust;          ///< how far noise is that of single pixels
    float times, darkest; ///< most and darkest of ResidualFeedback
    PlanesView<1> light, noise, texture, sure;
    PlanesView<2> fine, middle;
    PlanesView<3> residual, alone, picture;
    std::array<PlanesView<3>, feedback_levels> levels;

    template <class Real> QUELL_FLATTENED constexpr void operator()(AtOnce<Real>, int x, int y, int count) const {
        auto const n = load_pixels<Real>(noise, x, y), most = load_pixels<Real>(light, x, y) * times;
        auto const before = load_pixels<Real>(picture, x, y);
        auto off = zero<vec3<Real>>();
        auto const add = [&](Real const& share, vec3<Real> const& part) QUELL_INLINED {
            off = map([&](Real sum, Real a) QUELL_INLINED { return sum + masked(is_finite(a), share * clamp(a, -most, most)); }, off, part);
        };
        auto const held = load_pixels<Real>(fine, x, y), held_wider = load_pixels<Real>(middle, x, y);
        // No frequency is fed back more than whole, however many parts have it.
        auto const own = clamp(fma(n, Real(by.sample_noise), Real(by.sample)), Real(0.f), Real(1.f));
        auto const finest = fma(load_pixels<Real>(sure, x, y), Real(by.near_sure), fma(held.x, Real(by.near_held), Real(by.near_noise)));
        auto const finest_share = min(finest * n, 1.f - own), left = 1.f - own - max(finest_share, Real(0.f));
        auto const wide = fma(n, Real(by.wide_noise), fma(load_pixels<Real>(texture, x, y), Real(by.wide_texture), Real(by.wide)));
        auto const level = [&](std::size_t i) QUELL_INLINED { return load_pixels<Real>(levels[i], x, y); };
        add(own, load_pixels<Real>(residual, x, y));
        add(finest_share, level(0));
        add(min(held.x * held.y * by.fine_held, left), level(0) - level(1));
        add(min(held_wider.x * held_wider.y * by.middle_held, left), level(2) - level(3));
        add(min(wide, left), level(3));
        add(Real(by.alone), load_pixels<Real>(alone, x, y) - before);
        auto const is_picture = all_finite(before);
        auto const made = [&](Real a, Real more)
                              QUELL_INLINED { return select(is_picture, max(fma(more, Real(trust), a), min(a, a * darkest)), a); };
        store_pixels<Real>(picture, x, y, map(made, before, off), count);
    }
};

} // namespace detail

/// Adds to a picture what its samples tell that it lacks (ResidualFeedback).
/// @param rule     how
/// @param executor runs the passes
/// @param samples  that the picture was made of, linear, row by row; not finite where there is none
/// @param normal   a view of the surfaces' directions, of any length; zero: none
/// @param depth    a view of their distances; infinite: none
/// @param alone    the same frame denoised by itself; the picture again where it has no history
/// @param picture  the denoised one; is changed
/// @return how far noise was taken for that of single pixels, from 0, where nothing is added, to 1
/// @throws Error where these are not of one size, std::bad_alloc
template <Executor E>
float feed_back_residual(ResidualFeedback const& rule, E const& executor, std::vector<glm::vec3> const& samples,
                         ViewOf<Planar<>, Normal> normal, ViewOf<Planar<>, Depth> depth, std::vector<glm::vec3> const& alone,
                         std::vector<glm::vec3>& picture) {
    using namespace detail;
    check_residual_sizes("feed_back_residual", samples, normal.size, depth.size, picture);
    check_residual_sizes("feed_back_residual, alone", alone, normal.size, depth.size, picture);
    if (rule.limits.noise_radius < 0 || rule.limits.noise_radius > WindowSums<4>::largest_radius)
        raise_error("feed_back_residual, limits.noise_radius", std::to_string(rule.limits.noise_radius),
                    "give 0 to " + std::to_string(WindowSums<4>::largest_radius) + " pixels");
    auto const size = depth.size;
    float const unit = light_unit(picture);
    auto const before = in_planes(size, picture, unit), by_itself = in_planes(size, alone, unit);
    Brightness const brightness(executor, before.view());
    WindowSums<4> sums(size);
    auto const given = in_planes(size, samples, unit);
    float const trust = rule.of_neighbours.independence(shared_noise(rule.of_neighbours, LightLess{given.view(), before.view()}));
    PictureResidual const residual(executor, sums, rule.limits, given.view(), before.view(), brightness);
    FeedbackGates const gates(executor, sums, residual, before.view(), brightness);
    auto const levels =
        levels_of<feedback_levels>(executor, residual, {normal, depth, rule.depth_range, gates.light_logarithm.view(), rule.light_range});
    auto const sure = sureness(executor, sums, levels[0], gates.variance);
    auto const fine = held_shares(executor, sums, residual, levels[0], levels[1]),
               middle = held_shares(executor, sums, residual, levels[2], levels[3]);
    executor.for_each_pixel(
        {0, 0, size.width, size.height},
        FeedBack{.by = rule.shares.value_or(ResidualFeedbackShares::of_samples(rule.samples)),
                 .trust = trust,
                 .times = rule.most,
                 .darkest = rule.darkest,
                 .light = gates.light.view(),
                 .noise = gates.noise.view(),
                 .texture = gates.texture.view(),
                 .sure = sure.view(),
                 .fine = fine.view(),
                 .middle = middle.view(),
                 .residual = residual.value.view(),
                 .alone = by_itself.view(),
                 .picture = before.view(),
                 .levels = {levels[0].value.view(), levels[1].value.view(), levels[2].value.view(), levels[3].value.view()}});
    copy_out(before.view(), picture, unit);
    return trust;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET
