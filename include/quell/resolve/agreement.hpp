#pragma once

#include <quell/resolve/anti_alias.hpp>
#include <quell/resolve/picture_brightness.hpp>
#include <quell/resolve/window_sums.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <type_traits>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// How far the colours that frames around tell count beside those that a frame has itself. Both are estimates of the same colour: the
/// frame's own has the noise of its few samples, and what frames around tell has what vectors do not know of. With d the difference of
/// both, the least squared error is that of the share w = noise / d^2, of sums over a window.
///
/// The noise is known by the colours beside. A pixel's samples lie all over it, so that they see what differs as neighbouring pixels do:
/// the noise is the part noise_share() of g(1), where g(h) is half the mean squared difference of pixels that lie h apart (the variogram).
/// Where samples lie far beyond their pixel too, by depth of field or motion blur, noise is white: the part white_share() of 2 g(1) - g(2),
/// the variogram's value at distance 0 (the nugget).
struct Agreement {
    float samples = 1.f;     ///< of each pixel
    bool is_blurred = false; ///< whether samples lie beyond their pixel too
    int radius = 5;          ///< of the windows, in pixels; at most 16

    /// Noise of a pixel's colour as a part of the variance between neighbours. One sample has all of it. More are spread evenly over
    /// the pixel, and of an edge n of them have n^-1.5 of the noise of one (Mitchell 1996, "Consequences of Stratified Sampling in
    /// Graphics").
    [[nodiscard]] float noise_share() const {
        float const n = std::max(samples, 1.f);
        return std::min(1.f, 1.6f / (n * std::sqrt(n)));
    }
    /// The more samples there are, the rather are pixels that differ at random a texture than noise.
    [[nodiscard]] float white_share() const {
        float const n = std::max(samples, 1.f);
        return is_blurred ? std::max(noise_share(), std::min(1.f, 16.f / (n * n))) : noise_share();
    }
};

namespace detail {

/// Half the squared difference of a pixel's colour to that on the right of it and to that below, the mean of both.
/// @param step how far away these are, in pixels
template <class Real> QUELL_KERNEL Real half_difference(PlanesView<3> colour, int x, int y, int step) {
    auto const here = load_pixels<Real>(colour, x, y);
    auto const squared = [&](vec3<Real> const& other) QUELL_INLINED {
        auto const d = other - here;
        auto const square = dot(d, d);
        return masked(is_finite(square), square);
    };
    auto const columns = Real(static_cast<float>(x + step)) + lanes<Real>();
    auto sum = masked(columns < Real(static_cast<float>(colour.size.width)), squared(load_beside<Real>(colour, x + step, y)));
    if (y + step < colour.size.height) sum = sum + squared(load_pixels<Real>(colour, x, y + step));
    return sum * .25f;
}

/// How far the frames around count, from 0 to 1 for each pixel: see Agreement.
/// @param own    the frame's colours
/// @param others those that frames around tell, without the frame; not finite where they tell nothing
template <Executor E> Planes<1> agreement(Agreement const& rule, E const& executor, PlanesView<3> own, PlanesView<3> others) {
    auto const size = own.size;
    // Colours may be light of any unit.
    float const unit = light_unit(static_cast<double>(Brightness(executor, own).mean)), per_square = 1.f / (unit * unit);
    Planes<1> result(size);
    WindowSums<3> sums(size);
    sums.around<3>(
        executor, rule.radius,
        [=]<class Real>(AtOnce<Real>, int x, int y) {
            auto const d = load_pixels<Real>(others, x, y) - load_pixels<Real>(own, x, y);
            auto const square = dot(d, d);
            auto const off = masked(is_finite(square), square) * per_square;
            auto const known = masked(off > Real(0.f), Real(per_square));
            return std::array{off, half_difference<Real>(own, x, y, 1) * known, half_difference<Real>(own, x, y, 2) * known};
        },
        [=, to = result.view(), share = rule.noise_share(), white = rule.white_share()]<class Real>(AtOnce<Real>, int x, int y, int count,
                                                                                                    auto const& of_window) {
            auto const g = of_window[1], nugget = clamp(fma(g, Real(2.f), -of_window[2]), Real(0.f), g);
            auto const noise = fma(g - nugget, Real(share), nugget * white), nothing = Real(1e-12f); // where nothing differs, all agree
            store_pixels<Real>(to, x, y, min((noise + nothing) / (of_window[0] + nothing), Real(1.f)), count);
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
    auto told = policy;
    if (!policy.by_surface) told.own = 0.f; // how far the frame's own count is asked of the samples
    run_anti_alias(told, executor, here, before, after, light, to, others.view());
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
