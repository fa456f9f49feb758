#pragma once

#include <quell/filter/wavelet_taps.hpp>
#include <quell/frame/channels.hpp>
#include <quell/resolve/nearness.hpp>
#include <quell/resolve/picture_residual.hpp>

#include <array>
#include <cstdlib>
#include <utility>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// What a residual is not smoothed across: borders of surfaces, and of pieces of like light.
struct ResidualStops {
    ViewOf<Planar<>, Normal> normal;
    ViewOf<Planar<>, Depth> depth;
    float depth_range;   ///< part by which depths of one surface differ
    PlanesView<1> light; ///< the logarithm of the picture's light
    float light_range;   ///< how far that differs in one piece of light
};

/// A residual smoothed.
struct ResidualLevel {
    Planes<3> value; ///< made of all samples
    Planes<3> held;  ///< made of samples of the checkerboard's other half
    explicit ResidualLevel(Extent size) : value(size), held(size) {}
};

/// Smooths both halves of a residual over surfaces by a B-spline's 5x5 taps, `step` pixels apart.
struct SmoothResidual {
    static constexpr auto name = "smooth residual";
    int step;
    float depth_range, per_light_range;
    PlanesView<3> normal; ///< of length 1, or 0 where nothing is seen
    PlanesView<1> nearness, light;
    std::array<PlanesView<4>, 2> from, to; ///< of each half: the residual, and which part of a pixel's weights that is
    PlanesView<3> value, held;

    template <class Real> QUELL_FLATTENED constexpr void operator()(AtOnce<Real>, int x, int y, int count) const {
        constexpr auto& spline = CubicSpline::weights;
        auto const n = load_pixels<Real>(normal, x, y);
        auto const near = load_pixels<Real>(nearness, x, y), bright = load_pixels<Real>(light, x, y);
        auto const range = Real(depth_range * depth_range);
        std::array sums{zero<Value<4, Real>>(), zero<Value<4, Real>>()};
        Real whole(0.f);
        auto const add = [&](Real const& weight, int column, int row) QUELL_INLINED {
            whole = whole + weight;
            for (std::size_t half = 0; half < 2; ++half)
                sums[half] = add_scaled(sums[half], load_pixels<Real>(from[half], column, row), weight);
        };
        for (int j = -2; j <= 2; ++j) {
            int const row = y + j * step;
            if (row < 0 || row >= nearness.size.height) continue;
            for (int i = -2; i <= 2; ++i) {
                Real const w(spline[std::abs(i)] * spline[std::abs(j)]);
                if (i == 0 && j == 0) {
                    add(w, x, y);
                    continue;
                }
                int const column = x + i * step; // beside the image normals are zero
                auto const cosine = max(dot(n, load_pixels<Real>(normal, column, row)), Real(0.f));
                auto p = cosine * cosine;
                p = p * p, p = p * p, p = p * p, p = p * p; // to the power of 32
                auto const other = load_pixels<Real>(nearness, column, row);
                auto const nearest = max(other, near), behind = other - near;
                auto const square = max(nearest * nearest, Real(1e-37f)) * range;
                auto const step_of_light = (load_pixels<Real>(light, column, row) - bright) * per_light_range;
                add(w * p * square / (fma(behind, behind, square) * fma(step_of_light, step_of_light, Real(1.f))), column, row);
            }
        }
        auto const per_whole = 1.f / whole;
        for (std::size_t half = 0; half < 2; ++half) store_pixels<Real>(to[half], x, y, sums[half] = scale(sums[half], per_whole), count);
        auto const colour = [](Value<4, Real> const& sum) QUELL_INLINED { return vec3<Real>(sum.x, sum.y, sum.z); };
        auto const both_halves = add_scaled(sums[0], sums[1], Real(1.f));
        store_pixels<Real>(value, x, y, scale(colour(both_halves), 1.f / max(both_halves.w, Real(1e-6f))), count);
        // Where next to no other sample is of this surface, nothing is known.
        auto const is_second = checkerboard_half<Real>(x, y) > Real(0.5f);
        auto const others = map([&](Real a, Real b) QUELL_INLINED { return select(is_second, a, b); }, sums[0], sums[1]);
        auto const per_other = masked(others.w > Real(.02f), 1.f / max(others.w, Real(.02f)));
        store_pixels<Real>(held, x, y, scale(colour(others), per_other), count);
    }
};

/// The residual smoothed, the finest level first: each by steps twice as wide as those of the one before, from that one. At most four
/// levels, whose taps lie 16 pixels away.
template <std::size_t count, Executor E>
std::array<ResidualLevel, count> levels_of(E const& executor, PictureResidual const& residual, ResidualStops const& stops) {
    static_assert(count <= 4);
    auto const size = residual.size;
    Planes<3> directions(size);
    Planes<1> nearnesses(size);
    std::array from{Planes<4>(size), Planes<4>(size)}, to{Planes<4>(size), Planes<4>(size)};
    {
        auto const normal = directions.view(), off = residual.value.view();
        auto const near = nearnesses.view(), square = residual.mean_square.view();
        std::array const halves{from[0].view(), from[1].view()};
        for_all_pixels(executor, size, [=]<class Real>(AtOnce<Real>, int x, int y, int pixels) {
            auto const n = load_pixels<Real>(stops.normal, x, y);
            auto const length = dot(n, n);
            auto const per_length = masked(both(is_finite(length), length > Real(0.f)), 1.f / sqrt(max(length, Real(1e-37f))));
            store_pixels<Real>(normal, x, y, map([&](Real a) QUELL_INLINED { return masked(is_finite(length), a * per_length); }, n),
                               pixels);
            store_pixels<Real>(near, x, y, nearness(load_pixels<Real>(stops.depth, x, y)), pixels);
            auto const value = load_pixels<Real>(off, x, y);
            auto const is_sample = load_pixels<Real>(square, x, y) > Real(0.f);
            auto const is_second = checkerboard_half<Real>(x, y) > Real(0.5f);
            for (std::size_t half = 0; half < 2; ++half) {
                auto const here = both(is_sample, half == 0 ? invert(is_second) : is_second);
                store_pixels<Real>(halves[half], x, y,
                                   {masked(here, value.x), masked(here, value.y), masked(here, value.z), masked(here, Real(1.f))}, pixels);
            }
        });
    }
    auto levels = [&]<std::size_t... i>(std::index_sequence<i...>) { return std::array{((void)i, ResidualLevel(size))...}; }
    (std::make_index_sequence<count>{});
    int step = 1;
    for (auto& made : levels) {
        executor.for_each_pixel({0, 0, size.width, size.height}, SmoothResidual{.step = step,
                                                                                .depth_range = stops.depth_range,
                                                                                .per_light_range = 1.f / stops.light_range,
                                                                                .normal = directions.view(),
                                                                                .nearness = nearnesses.view(),
                                                                                .light = stops.light,
                                                                                .from = {from[0].view(), from[1].view()},
                                                                                .to = {to[0].view(), to[1].view()},
                                                                                .value = made.value.view(),
                                                                                .held = made.held.view()});
        std::swap(from, to), step *= 2;
    }
    return levels;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
