#pragma once

#include <quell/execute/executor.hpp>
#include <quell/filter/wavelet_taps.hpp>
#include <quell/frame/channels.hpp>
#include <quell/image/planar.hpp>
#include <quell/resolve/nearness.hpp>
#include <quell/resolve/residual.hpp>

#include <array>
#include <cstdlib>
#include <optional>
#include <utility>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

inline constexpr int residual_bands = 3; ///< of 1, 2 and 4 pixels

/// The residual of every second pixel, and which part of a pixel's weights that is.
struct ResidualHalf {
    ImageOf<Planar<>, Albedo> sum;
    ImageOf<Planar<>, Depth> weight;
    explicit ResidualHalf(Extent size) : sum(size), weight(size) {}
};

/// What a residual is not smoothed across.
struct ResidualStops {
    ViewOf<Planar<>, Normal> normal;
    ViewOf<Planar<>, Depth> depth;
    float depth_range;                              ///< part by which depths of one surface differ
    std::optional<ViewOf<Planar<>, Depth>> light{}; ///< the logarithm of the picture's light; none: smooth across its edges
    float light_range = 1.f;                        ///< how far that differs in one piece of light
};

/// Smooths both halves over surfaces by a B-spline's 5x5 taps, `step` pixels apart.
struct SmoothResidual {
    static constexpr auto name = "smooth residual";
    using Colours = ViewOf<Planar<>, Albedo>;
    using Numbers = ViewOf<Planar<>, Depth>;
    int step;
    float per_depth_range, per_light_range; ///< the latter 0: light is not looked at
    ViewOf<Planar<>, Normal> normal;
    Numbers depth, light;
    std::array<Colours, 2> sum, to_sum;
    std::array<Numbers, 2> weight, to_weight;

    template <class Real> QUELL_KERNEL void operator()(AtOnce<Real>, int x, int y, int count) const {
        constexpr auto& spline = CubicSpline::weights;
        auto const n = load_pixels<Real>(normal, x, y);
        auto const square = dot(n, n), here = nearness(load_pixels<Real>(depth, x, y));
        auto const columns = Real(static_cast<float>(x)) + lanes<Real>();
        Real const width(static_cast<float>(depth.size.width));
        std::array sums{zero<vec3<Real>>(), zero<vec3<Real>>()};
        std::array<Real, 2> weights{Real(0.f), Real(0.f)};
        Real whole(0.f);
        for (int j = -2; j <= 2; ++j) {
            int const row = y + j * step;
            if (row < 0 || row >= depth.size.height) continue;
            for (int i = -2; i <= 2; ++i) {
                Real w(spline[std::abs(i)] * spline[std::abs(j)]);
                int const column = x + i * step;
                if (i != 0 || j != 0) {
                    auto const m = load_pixels<Real>(normal, column, row);
                    auto const cosine = max(dot(n, m), Real(0.f));
                    auto p = cosine * cosine / max(square * dot(m, m), Real(1e-20f));
                    p = p * p, p = p * p, p = p * p, p = p * p; // cosine to the power of 32
                    auto const other = nearness(load_pixels<Real>(depth, column, row));
                    auto const off = (other - here) / max(max(other, here), Real(1e-20f)) * per_depth_range;
                    auto const there = columns + static_cast<float>(i * step);
                    auto const usable = both(there >= Real(0.f), there < width, is_finite(p));
                    w = masked(usable, w * p / fma(off, off, Real(1.f)));
                    if (per_light_range > 0.f) {
                        auto const step_of_light =
                            (load_pixels<Real>(light, column, row) - load_pixels<Real>(light, x, y)) * per_light_range;
                        w = masked(usable, w / fma(step_of_light, step_of_light, Real(1.f)));
                    }
                }
                whole = whole + w;
                for (std::size_t half = 0; half < 2; ++half) {
                    sums[half] = add_scaled(sums[half], load_pixels<Real>(sum[half], column, row), w);
                    weights[half] = fma(load_pixels<Real>(weight[half], column, row), w, weights[half]);
                }
            }
        }
        auto const per_whole = 1.f / whole;
        for (std::size_t half = 0; half < 2; ++half) {
            store_pixels<Real>(to_sum[half], x, y, scale(sums[half], per_whole), count);
            store_pixels<Real>(to_weight[half], x, y, weights[half] * per_whole, count);
        }
    }
};

/// What one band adds, or what one level is.
struct ResidualBand {
    std::vector<glm::vec3> value; ///< made of all samples
    std::vector<glm::vec3> held;  ///< made of samples of the other half
};

/// The residual smoothed, the finest level first: each by steps twice as wide as those of the one before, from that one.
template <std::size_t Count, Executor E>
std::array<ResidualBand, Count> levels_of(E const& executor, PictureResidual const& residual, ResidualStops const& stops) {
    auto const size = residual.size;
    auto const pixels = residual.value.size();
    auto const each_pixel = [&](auto&& visit) {
        std::size_t i = 0;
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) visit(x, y, i++);
    };
    std::array from{ResidualHalf(size), ResidualHalf(size)}, to{ResidualHalf(size), ResidualHalf(size)};
    each_pixel([&](int x, int y, std::size_t i) {
        for (std::size_t half = 0; half < 2; ++half) {
            bool const here = residual.is_in(half, i);
            for (int c = 0; c < 3; ++c) from[half].sum.view().set(c, x, y, here ? residual.value[i][c] : 0.f);
            from[half].weight.view().set(0, x, y, here ? 1.f : 0.f);
        }
    });
    std::array<ResidualBand, Count> levels;
    int step = 1;
    for (auto& made : levels) {
        executor.for_each_pixel({0, 0, size.width, size.height},
                                SmoothResidual{.step = step,
                                               .per_depth_range = 1.f / stops.depth_range,
                                               .per_light_range = stops.light ? 1.f / stops.light_range : 0.f,
                                               .normal = stops.normal,
                                               .depth = stops.depth,
                                               .light = stops.light.value_or(stops.depth),
                                               .sum = {from[0].sum.view(), from[1].sum.view()},
                                               .to_sum = {to[0].sum.view(), to[1].sum.view()},
                                               .weight = {from[0].weight.view(), from[1].weight.view()},
                                               .to_weight = {to[0].weight.view(), to[1].weight.view()}});
        made.value.resize(pixels), made.held.resize(pixels);
        each_pixel([&](int x, int y, std::size_t i) {
            std::array<glm::vec3, 2> sum{};
            std::array<float, 2> weight{};
            for (std::size_t half = 0; half < 2; ++half) {
                for (int c = 0; c < 3; ++c) sum[half][c] = to[half].sum.view().get(c, x, y);
                weight[half] = to[half].weight.view().get(0, x, y);
            }
            made.value[i] = (sum[0] + sum[1]) / std::max(weight[0] + weight[1], 1e-6f);
            // Where next to no other sample is of this surface, nothing is known.
            auto const other = 1 - residual.half_of(i);
            made.held[i] = weight[other] > .02f ? sum[other] / weight[other] : glm::vec3(0.f);
        });
        std::swap(from, to), step *= 2;
    }
    return levels;
}

/// The residual's bands, the finest first: what each level has more or less than the next.
template <Executor E>
std::array<ResidualBand, residual_bands> bands_of(E const& executor, PictureResidual const& residual, ResidualStops const& stops) {
    auto bands = levels_of<residual_bands>(executor, residual, stops);
    for (std::size_t band = 0; band + 1 < bands.size(); ++band)
        for (std::size_t i = 0; i < residual.value.size(); ++i)
            bands[band].value[i] -= bands[band + 1].value[i], bands[band].held[i] -= bands[band + 1].held[i];
    return bands;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
