#pragma once

#include <quell/resolve/feedback_gates.hpp>
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
#include <utility>
#include <vector>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Gives back to a denoised picture what its filter took out by mistake, by shares that were fitted to renders: see
/// ResidualFeedbackShares. It is a kind of twicing (Tukey 1977, "Exploratory Data Analysis").
///
/// The residual, samples minus picture, is smoothed over surfaces and over pieces of like light, in four levels with steps of 1, 2, 4 and 8
/// pixels. A part of the widest level and of the finest band between levels is added; nothing of the pixel's own residual, which is noise
/// first. How much of the level depends on the noise and on the light's texture, how much of the band on what samples that were held out
/// have in common with it: with B the band at even pixels, made of the residual r at odd ones, and the other way round as on a
/// checkerboard, sum r B / sum B^2 over a window.
///
/// Shares that were fitted to other renders may be wrong for this one. So all of it comes back by the part w that samples bear out: with A
/// what the levels give and H the same of held-out samples, w = sum r H / sum A^2 over a window. Before any sample is seen, w is 1 with
/// variance `held_variance`; sum r H has the variance 2 sum (r H)^2; w is the mean after both, from 0 to 1.
struct ResidualFeedback {
    float samples = 1.f;                            ///< of each pixel; shares lie between those of 1 and of 16
    std::optional<ResidualFeedbackShares> shares{}; ///< others; none: those that were fitted for `samples`
    float depth_range = 0.05f;                      ///< part by which depths of one surface differ
    float light_range = 0.15f;                      ///< by how much the logarithm of one piece of light differs
    float most = 3.f;                               ///< what is added of each part is at most so many times the light around
    float darkest = 0.2f;                           ///< of the picture's light so much stays at least
    ResidualLimits limits{};                        ///< of the residual
    int held_radius = 16;                           ///< of the windows that w is taken over, in pixels; at most 16
    float held_variance = 3.f;                      ///< of w, as it is known before; above 0
    SharedNoise of_neighbours{};                    ///< where neighbours share their noise, less is added, or nothing
};

namespace detail {

inline constexpr int feedback_levels = 4; ///< of 1, 2, 4 and 8 pixels

/// What each pixel gets back of the parts of a residual.
struct FedBack {
    static constexpr auto name = "fed back";
    ResidualFeedbackShares by;
    float times; ///< most of ResidualFeedback
    PlanesView<1> light, noise, texture;
    PlanesView<2> fine;
    std::array<PlanesView<3>, 3> levels, held_levels; ///< the finest two, and the widest
    PlanesView<3> smooth;                             ///< gets what levels give
    PlanesView<3> smooth_held;                        ///< gets the same of the samples that were held out

    template <class Real> QUELL_FLATTENED constexpr void operator()(AtOnce<Real>, int x, int y, int count) const {
        auto const n = load_pixels<Real>(noise, x, y), most = load_pixels<Real>(light, x, y) * times;
        auto const held = load_pixels<Real>(fine, x, y);
        // No frequency is fed back more than whole.
        auto const fine_share = min(held.x * held.y * by.fine_held, Real(1.f));
        auto const wide_share =
            min(fma(n, Real(by.wide_noise), fma(load_pixels<Real>(texture, x, y), Real(by.wide_texture), Real(by.wide))), Real(1.f));
        auto const part = [&](Real share, Real a) QUELL_INLINED { return masked(is_finite(a), share * clamp(a, -most, most)); };
        auto const of_levels = [&](std::array<PlanesView<3>, 3> const& from) QUELL_INLINED {
            auto const band = load_pixels<Real>(from[0], x, y) - load_pixels<Real>(from[1], x, y);
            return map([&](Real b, Real wide) QUELL_INLINED { return part(fine_share, b) + part(wide_share, wide); }, band,
                       load_pixels<Real>(from[2], x, y));
        };
        store_pixels<Real>(smooth, x, y, of_levels(levels), count);
        store_pixels<Real>(smooth_held, x, y, of_levels(held_levels), count);
    }
};

/// Adds all that comes back to a picture, as far as samples that were held out bear it out: the share w of ResidualFeedback.
/// @param trust       how far noise is that of single pixels
/// @param smooth      what levels give
/// @param smooth_held the same of held-out samples
/// @param to          the picture
template <Executor E>
void add_as_held(E const& executor, WindowSums<4>& sums, ResidualFeedback const& rule, float trust, PictureResidual const& residual,
                 Planes<3> const& smooth, Planes<3> const& smooth_held, PlanesView<3> to) {
    auto const off = residual.value.view(), given = smooth.view(), held = smooth_held.view();
    auto const square = residual.mean_square.view();
    constexpr float twice = 2.f; // the product of two samples is in the sum once for each of them
    sums.around<3>(
        executor, rule.held_radius,
        [=]<class Real>(AtOnce<Real>, int x, int y) {
            auto const mean = load_pixels<Real>(square, x, y);
            auto const per_square = masked(mean > Real(0.f), 1.f / max(mean, Real(1e-37f)));
            auto const part = load_pixels<Real>(given, x, y);
            auto const product = dot(load_pixels<Real>(off, x, y), load_pixels<Real>(held, x, y)) * per_square;
            return std::array{product, dot(part, part) * per_square, product * product};
        },
        [=, prior = rule.held_variance, darkest = rule.darkest]<class Real>(AtOnce<Real>, int x, int y, int count, auto const& of_window) {
            // Where the levels give nothing, nothing is known of w.
            auto const whole = of_window[1] + 1e-15f, doubt = fma(of_window[2], Real(twice / prior), Real(1e-20f)) / (whole * whole);
            auto const w = clamp((of_window[0] / whole + doubt) / (1.f + doubt), Real(0.f), Real(1.f)) * trust;
            auto const old = load_pixels<Real>(to, x, y), more = load_pixels<Real>(given, x, y);
            auto const is_picture = all_finite(old);
            auto const made = [&](Real a, Real b) QUELL_INLINED { return select(is_picture, max(fma(b, w, a), min(a, a * darkest)), a); };
            store_pixels<Real>(to, x, y, map(made, old, more), count);
        });
}

} // namespace detail

/// Adds to a picture what its samples tell that it lacks (ResidualFeedback).
/// @param rule     how
/// @param executor runs the passes
/// @param samples  that the picture was made of, linear, row by row; not finite where there is none
/// @param normal   a view of the surfaces' directions, of any length; zero: none
/// @param depth    a view of their distances; infinite: none
/// @param picture  the denoised one; is changed
/// @return how far noise was taken for that of single pixels, from 0, where nothing is added, to 1
/// @throws Error where these are not of one size, std::bad_alloc
template <Executor E>
float feed_back_residual(ResidualFeedback const& rule, E const& executor, std::vector<glm::vec3> const& samples,
                         ViewOf<Planar<>, Normal> normal, ViewOf<Planar<>, Depth> depth, std::vector<glm::vec3>& picture) {
    using namespace detail;
    check_residual_sizes("feed_back_residual", samples, normal.size, depth.size, picture);
    for (auto const& [name, radius] : {std::pair{"limits.noise_radius", rule.limits.noise_radius}, {"held_radius", rule.held_radius}})
        if (radius < 0 || radius > WindowSums<4>::largest_radius)
            raise_error("feed_back_residual, " + std::string(name), std::to_string(radius),
                        "give 0 to " + std::to_string(WindowSums<4>::largest_radius) + " pixels");
    if (!(rule.held_variance > 0.f))
        raise_error("feed_back_residual, held_variance", std::to_string(rule.held_variance), "give more than 0");
    auto const size = depth.size;
    float const unit = light_unit(picture);
    auto const before = in_planes(size, picture, unit);
    Brightness const brightness(executor, before.view());
    WindowSums<4> sums(size);
    auto const given = in_planes(size, samples, unit);
    float const trust = rule.of_neighbours.independence(shared_noise(rule.of_neighbours, LightLess{given.view(), before.view()}));
    PictureResidual const residual(executor, sums, rule.limits, given.view(), before.view(), brightness);
    FeedbackGates const gates(executor, sums, residual, before.view(), brightness);
    auto const levels =
        levels_of<feedback_levels>(executor, residual, {normal, depth, rule.depth_range, gates.light_logarithm.view(), rule.light_range});
    auto const fine = held_shares(executor, sums, residual, levels[0], levels[1]);
    Planes<3> smooth(size), smooth_held(size);
    executor.for_each_pixel({0, 0, size.width, size.height},
                            FedBack{.by = rule.shares.value_or(ResidualFeedbackShares::of_samples(rule.samples)),
                                    .times = rule.most,
                                    .light = gates.light.view(),
                                    .noise = gates.noise.view(),
                                    .texture = gates.texture.view(),
                                    .fine = fine.view(),
                                    .levels = {levels[0].value.view(), levels[1].value.view(), levels[3].value.view()},
                                    .held_levels = {levels[0].held.view(), levels[1].held.view(), levels[3].held.view()},
                                    .smooth = smooth.view(),
                                    .smooth_held = smooth_held.view()});
    add_as_held(executor, sums, rule, trust, residual, smooth, smooth_held, before.view());
    copy_out(before.view(), picture, unit);
    return trust;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET
