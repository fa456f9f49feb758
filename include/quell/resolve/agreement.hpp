#pragma once

#include <quell/resolve/anti_alias.hpp>
#include <quell/resolve/picture_residual.hpp>
#include <quell/resolve/window_sums.hpp>

#include <array>
#include <cstddef>
#include <span>
#include <type_traits>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// How far the colours that frames around tell agree with those that a frame has itself. The difference d of both has two parts: noise of
/// single samples, which is another one in each pixel, and what the frames around have wrong, which neighbouring pixels have in common.
/// Over a window, the second part is the mean of d(p) d(q) over neighbours p and q, in that of four directions in which it is least: at
/// edges of things, samples are off along the edge alone.
///
/// The frames around count whole where that is at most the part `least` of the mean of d^2, and not at all from the part `most` on.
struct Agreement {
    int radius = 5;      ///< of the windows, in pixels; at most 16
    float caution = 1.f; ///< standard errors that are taken off what neighbours have in common
    float least = 0.f;   ///< part that is tolerated
    float most = .06f;   ///< part from which on frames around count nothing

    /// For colours that are means of several samples, whose own noise is little beside what frames around may have wrong.
    [[nodiscard]] static constexpr Agreement of_means() { return {.caution = 0.f, .least = -.05f, .most = .05f}; }
};

namespace detail {

/// How far the frames around count, from 0 to 1 for each pixel: see Agreement.
/// @param own    the frame's colours
/// @param others those that frames around tell, without the frame; not finite where they tell nothing
template <Executor E> Planes<1> agreement(Agreement const& rule, E const& executor, PlanesView<3> own, PlanesView<3> others) {
    auto const size = own.size;
    Planes<3> differences(size);
    auto const off = differences.view();
    // Colours may be light of any unit, and its fourth power is taken.
    float const per_unit = 1.f / light_unit(static_cast<double>(Brightness(executor, own).mean));
    for_all_pixels(executor, size, [=]<class Real>(AtOnce<Real>, int x, int y, int count) {
        auto const d = load_pixels<Real>(own, x, y) - load_pixels<Real>(others, x, y);
        auto const is_known = all_finite(d);
        store_pixels<Real>(off, x, y, map([&](Real a) QUELL_INLINED { return masked(is_known, a * per_unit); }, d), count);
    });
    Planes<1> result(size);
    WindowSums<9> sums(size);
    sums.around<9>(
        executor, rule.radius,
        [=]<class Real>(AtOnce<Real>, int x, int y) {
            auto const here = load_pixels<Real>(off, x, y);
            auto const product = [&](int dx, int dy) QUELL_INLINED {
                return y + dy < off.size.height ? Real(dot(here, load_pixels<Real>(off, x + dx, y + dy))) : Real(0.f);
            };
            std::array const p{product(1, 0), product(0, 1), product(1, 1), product(-1, 1)};
            return std::array{dot(here, here), p[0], p[1], p[2], p[3], p[0] * p[0], p[1] * p[1], p[2] * p[2], p[3] * p[3]};
        },
        [=, to = result.view()]<class Real>(AtOnce<Real>, int x, int y, int count, auto const& of_window) {
            Real common(1e30f);
            for (std::size_t i = 1; i <= 4; ++i) common = min(common, of_window[i] - sqrt(of_window[i + 4]) * rule.caution);
            auto const part = common / max(of_window[0], Real(1e-30f));
            store_pixels<Real>(to, x, y, clamp((rule.most - part) * (1.f / (rule.most - rule.least)), Real(0.f), Real(1.f)), count);
        });
    return result;
}

} // namespace detail

/// Anti-aliases as anti_alias() does, as far as the frames around agree with the frame's own colours; elsewhere it has the product of light
/// and these. Vectors do not tell of a sky that turns, of a texture that changes or of a lens: the samples themselves do. For a CPU.
/// @param agreement how far they have to agree
/// @param policy    as for anti_alias()
/// @param executor  runs the passes
/// @param here      the frame that the light is of
/// @param before    as for anti_alias()
/// @param after     as for anti_alias()
/// @param light     a view of three components
/// @param to        a view of three components, other than the others
/// @return how far the frames around count, from 0 to 1 for each pixel
/// @throws std::bad_alloc
template <Executor E, ImageView Light, ImageView To>
Planar<>::Image<1> anti_alias_where_agreed(Agreement const& agreement, AntiAliased const& policy, E const& executor,
                                           ColouredFrame<> const& here, std::span<ColouredFrame<> const> before,
                                           std::span<ColouredFrame<> const> after, Light const& light, To const& to) {
    using namespace detail;
    Planes<3> others(here.depth.size);
    run_anti_alias(policy, executor, here, before, after, light, to, others.view());
    auto agrees = detail::agreement(agreement, executor, here.colour, others.view());
    for_all_pixels(executor, here.depth.size, [=, share = agrees.view()]<class Real>(AtOnce<Real>, int x, int y, int count) {
        auto const own = load_pixels<Real>(here.colour, x, y) * load_pixels<Real>(light, x, y);
        auto const part = load_pixels<Real>(share, x, y);
        // What is not finite stays so where it counts nothing.
        auto const mixed =
            map([&](Real plain, Real all) QUELL_INLINED { return select(part > Real(0.f), plain + (all - plain) * part, plain); }, own,
                load_pixels<Real>(to, x, y));
        store_pixels<Real>(to, x, y, mixed, count);
    });
    return agrees;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET
