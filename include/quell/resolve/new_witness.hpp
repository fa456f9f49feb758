#pragma once

#include <quell/core/error.hpp>
#include <quell/core/value.hpp>
#include <quell/resolve/residual_bands.hpp>
#include <quell/resolve/window_sums.hpp>

#include <array>
#include <string>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// How far what a frame before or after lacks says something new of what this one lacks (RepeatedResidual). Correlations of both residuals
/// over a window tell whether their noise is independent:
///
/// - A residual that is nearly the same has the same samples, as a frame that is held: no two frames' noise is that small beside what both
///   lack.
/// - One that goes with that of now more on the screen than along the motion has noise that stays there, as that of a seed that is
/// repeated.
/// - What both have in common, beyond chance, and what has nothing in common with its own neighbours, is noise that goes along with
///   surfaces, as that of light from a texture or a cache. What a filter takes out of a picture by mistake has edges, lines and shapes, if
///   fine ones. The measure is the part of the product of both that is left where one is blurred, as 0 for white noise and 1 for smooth
///   shapes.
///
/// Each of them goes from nothing to whole between two numbers.
struct NewWitness {
    int radius = 16;        ///< of the windows, in pixels
    float alike = .6f;      ///< correlation of a residual around with that of now, up to which that frame counts whole
    float same = .85f;      ///< and from which on it counts nothing
    float stays = .05f;     ///< by how much correlation may be larger on the screen: whole up to that, and nothing from twice as much on
    float common = .2f;     ///< correlation from which on neighbours are asked; below two fifths of that they are not, as it may be chance
    float scattered = .1f;  ///< the measure of neighbours up to which what is common counts nothing
    float in_shapes = .18f; ///< and from which on it counts whole
};

namespace detail {

/// @throws Error where a number is out of range
inline void check_rule(NewWitness const& rule) {
    constexpr int largest = WindowSums<6>::largest_radius;
    if (rule.radius < 0 || rule.radius > largest)
        raise_error("NewWitness::radius", std::to_string(rule.radius), "give 0 to " + std::to_string(largest));
    if (!(rule.stays > 0.f)) raise_error("NewWitness::stays", std::to_string(rule.stays), "give more than 0");
    if (!(rule.same > rule.alike)) raise_error("NewWitness::same", std::to_string(rule.same), "give more than alike");
    if (!(rule.common > 0.f)) raise_error("NewWitness::common", std::to_string(rule.common), "give more than 0");
    if (!(rule.in_shapes > rule.scattered))
        raise_error("NewWitness::in_shapes", std::to_string(rule.in_shapes), "give more than scattered");
}

/// Lessens how far a frame around counts where it is no new witness.
/// @param now       what this frame lacks
/// @param there     what that one lacks, where its surfaces are now
/// @param on_screen and where they were there
/// @param light     around each pixel
/// @param is_known  where that frame is known; is changed, but never to 0
/// @param has_new_samples is set to where its samples are others, by the first two of the three
template <Executor E>
void count_witness(E const& executor, NewWitness const& rule, WindowSums<6>& sums, PlanesView<3> now, BlurredResidual const& there,
                   PlanesView<3> on_screen, PlanesView<1> light, PlanesView<1> is_known, PlanesView<1> has_new_samples) {
    float const of_white = there.of_white;
    sums.around<6>(
        executor, rule.radius,
        [=, there = there.whole.view(), blurred = there.blurred[0].view()]<class Real>(AtOnce<Real>, int x, int y) {
            auto const bright = load_pixels<Real>(light, x, y), per_square = 1.f / (bright * bright);
            auto const a = load_pixels<Real>(now, x, y), b = load_pixels<Real>(there, x, y), c = load_pixels<Real>(on_screen, x, y);
            return std::array{dot(a, a) * per_square, dot(a, b) * per_square, dot(b, b) * per_square,
                              dot(a, c) * per_square, dot(c, c) * per_square, dot(a, load_pixels<Real>(blurred, x, y)) * per_square};
        },
        [=]<class Real>(AtOnce<Real>, int x, int y, int count, auto const& of_window) {
            auto const tiny = Real(1e-30f);
            auto const correlation = [&](Real const& common, Real const& square)
                                         QUELL_INLINED { return common / max(sqrt(of_window[0]) * sqrt(square), tiny); };
            auto const ramp = [&](Real const& value, float nothing, float whole)
                                  QUELL_INLINED { return clamp((value - nothing) * (1.f / (whole - nothing)), Real(0.f), Real(1.f)); };
            auto const alike = correlation(of_window[1], of_window[2]), stays = correlation(of_window[3], of_window[4]) - alike;
            auto const smooth = (of_window[5] / max(of_window[1], tiny) - of_white) * (1.f / (1.f - of_white));
            auto const is_new = ramp(alike, rule.same, rule.alike) * ramp(stays, 2.f * rule.stays, rule.stays);
            auto const is_detail = max(ramp(smooth, rule.scattered, rule.in_shapes), ramp(alike, rule.common, .4f * rule.common));
            auto const known = load_pixels<Real>(is_known, x, y);
            store_pixels<Real>(has_new_samples, x, y, known * is_new, count);
            store_pixels<Real>(is_known, x, y, known * max(is_new * is_detail, Real(1e-6f)), count); // 0: unknown
        });
}

} // namespace detail

} // namespace quell::inline QUELL_INSTRUCTION_SET
