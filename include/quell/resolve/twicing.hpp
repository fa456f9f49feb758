#pragma once

#include <quell/execute/executor.hpp>
#include <quell/frame/channels.hpp>
#include <quell/image/planar.hpp>
#include <quell/resolve/box_sums.hpp>

#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Gives back to a denoised picture what its filter took out by mistake: it smooths what the samples have more or less than the picture,
/// and adds that as far as it is more than noise (twicing: Tukey 1977, "Exploratory Data Analysis").
///
/// The residual, samples minus picture, is smoothed over surfaces in steps of 1, 2 and 4 pixels (a-trous, Dammertz et al. 2010), and split
/// into the bands between them. What a band is worth is told by samples that it was not made of: B is the band at even pixels made of the
/// residual r at odd ones, and the other way round, as on a checkerboard. Over a window the share of it that brings the picture nearest to
/// the truth is
///
///     w = sum r B / sum B^2
///
/// with terms divided by the residual's mean square around. Noise alone gives shares of both signs, equally often. So the band is added
/// where z, sum r B over its standard deviation, is more than a threshold, above which there are `false_share` times as many windows as
/// there are below its negative. Less is added where there is something in a larger window, or in the image as a whole: fine textures show
/// there, which no small window is sure of.
struct Twicing {
    int radius = 6;                 ///< of the windows, in pixels
    int wide_radius = 30;           ///< of the larger ones
    int noise_radius = 3;           ///< of the squares in which the residual's mean square is taken
    float false_share = 0.2f;       ///< of windows taken, how many may be noise
    float shrinkage = 0.3f;         ///< part of the threshold that is taken off the sums
    float wide_certainty = 3.f;     ///< standard deviations taken off the sums over larger windows
    float certainty = 2.f;          ///< standard deviations taken off the sums over all the image
    float most = 20.f;              ///< samples are at most so many times the picture's luminance
    float spike = 3.f;              ///< a residual is at most so many times the root mean square around; what is more is spread there
    float dark = 0.02f;             ///< part of the image's mean luminance that is added to that
    float depth_range = 0.05f;      ///< part by which depths of one surface differ
    static constexpr int bands = 3; ///< of 1, 2 and 4 pixels
};

namespace detail {

/// The residual of every second pixel, and which part of a pixel's weights that is.
struct ResidualHalf {
    ImageOf<Planar<>, Albedo> sum;
    ImageOf<Planar<>, Depth> weight;
    explicit ResidualHalf(Extent size) : sum(size), weight(size) {}
};

/// Smooths both halves over surfaces by a B-spline's 5x5 taps, `step` pixels apart.
struct SmoothResidual {
    static constexpr auto name = "smooth residual";
    using Colours = ViewOf<Planar<>, Albedo>;
    using Numbers = ViewOf<Planar<>, Depth>;
    int step;
    float per_depth_range;
    ViewOf<Planar<>, Normal> normal;
    Numbers depth;
    std::array<Colours, 2> sum, to_sum;
    std::array<Numbers, 2> weight, to_weight;

    template <class Real> QUELL_KERNEL void operator()(AtOnce<Real>, int x, int y, int count) const {
        constexpr std::array spline{0.0625f, 0.25f, 0.375f, 0.25f, 0.0625f};
        auto const n = load_pixels<Real>(normal, x, y);
        auto const square = dot(n, n), nearness = nearness_at<Real>(x, y);
        auto const columns = Real(static_cast<float>(x)) + lanes<Real>();
        Real const width(static_cast<float>(depth.size.width));
        std::array sums{zero<vec3<Real>>(), zero<vec3<Real>>()};
        std::array<Real, 2> weights{Real(0.f), Real(0.f)};
        Real whole(0.f);
        for (int j = -2; j <= 2; ++j) {
            int const row = y + j * step;
            if (row < 0 || row >= depth.size.height) continue;
            for (int i = -2; i <= 2; ++i) {
                Real w(spline[static_cast<std::size_t>(i + 2)] * spline[static_cast<std::size_t>(j + 2)]);
                int const column = x + i * step;
                if (i != 0 || j != 0) {
                    auto const m = load_pixels<Real>(normal, column, row);
                    auto const cosine = max(dot(n, m), Real(0.f));
                    auto p = cosine * cosine / max(square * dot(m, m), Real(1e-20f));
                    p = p * p, p = p * p, p = p * p, p = p * p; // cosine to the power of 32
                    auto const other = nearness_at<Real>(column, row);
                    auto const off = (other - nearness) / max(max(other, nearness), Real(1e-20f)) * per_depth_range;
                    auto const there = columns + static_cast<float>(i * step);
                    auto const usable = both(there >= Real(0.f), there < width, is_finite(p));
                    w = masked(usable, w * p / fma(off, off, Real(1.f)));
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

private:
    template <class Real> QUELL_KERNEL Real nearness_at(int x, int y) const {
        auto const d = load_pixels<Real>(depth, x, y);
        return masked(is_finite(d), 1.f / max(d, Real(1e-20f)));
    }
};

/// The least z that is exceeded by few windows of noise, judged by how many lie below its negative. None: there is none.
/// @param z           of each window, row by row
/// @param false_share how many of the windows above may be noise
/// @param least_false windows that overlap have the same noise: how many are taken to lie below at least
inline std::optional<double> threshold_above_noise(std::vector<double> const& z, double false_share, double least_false) {
    constexpr int steps = 16;
    std::array<double, steps + 1> above{}, below{};
    for (double const value : z) {
        auto const step = static_cast<std::size_t>(std::min(std::abs(value) * 2., static_cast<double>(steps)));
        ++(value < 0. ? below : above)[step];
    }
    std::optional<double> found;
    double more = 0., less = least_false;
    for (std::size_t step = steps; step >= 1; --step) {
        more += above[step], less += below[step];
        if (more > 0. && less <= false_share * more) found = 0.5 * static_cast<double>(step);
    }
    return found;
}

/// Their dot product.
inline double product_of(glm::vec3 const& a, glm::vec3 const& b) {
    double sum = 0.;
    for (int c = 0; c < 3; ++c) sum += static_cast<double>(a[c]) * static_cast<double>(b[c]);
    return sum;
}

/// Samples minus picture.
struct PictureResidual {
    Extent size;
    std::vector<glm::vec3> value;    ///< 0 where there is no sample
    std::vector<double> mean_square; ///< of the pixels around, and of a hundredth of the picture's luminance; 0 where there is no sample

    PictureResidual(Twicing const& rule, Extent size_, std::vector<glm::vec3> const& samples, std::vector<glm::vec3> const& picture)
        : size(size_), value(samples.size(), glm::vec3(0.f)), mean_square(samples.size(), 0.) {
        auto const pixels = value.size();
        std::vector<double> bright(pixels), known(pixels);
        double sum = 0.;
        for (std::size_t i = 0; i < pixels; ++i) {
            float const luminance_here = luminance(vec3<float>(picture[i]));
            if (is_finite(luminance_here))
                sum += static_cast<double>(luminance_here), bright[i] = std::abs(static_cast<double>(luminance_here));
        }
        double const dark = static_cast<double>(rule.dark) * sum / static_cast<double>(pixels) + 1e-6;
        for (std::size_t i = 0; i < pixels; ++i) {
            bright[i] += dark;
            float const most = rule.most * static_cast<float>(bright[i]);
            glm::vec3 off(0.f);
            bool is_known = true;
            for (int c = 0; c < 3; ++c) {
                off[c] = std::min(samples[i][c], most) - picture[i][c];
                is_known = is_known && is_finite(samples[i][c]) && is_finite(off[c]);
            }
            if (is_known) value[i] = off, mean_square[i] = product_of(off, off), known[i] = 1.;
        }
        auto const is_sample = known;
        box_sums(size, mean_square, rule.noise_radius), box_sums(size, known, rule.noise_radius);
        for (std::size_t i = 0; i < pixels; ++i)
            mean_square[i] = is_sample[i] > 0. ? mean_square[i] / known[i] + 1e-4 * bright[i] * bright[i] : 0.;
        for (std::size_t const half : {0u, 1u}) spread_spikes(rule, half);
    }
    /// Which half of the checkerboard a pixel is of.
    [[nodiscard]] std::size_t half_of(std::size_t pixel) const {
        auto const width = static_cast<std::size_t>(size.width);
        return (pixel / width + pixel % width) % 2;
    }
    /// Whether a pixel has a sample, and is of that half.
    [[nodiscard]] bool is_in(std::size_t half, std::size_t pixel) const { return mean_square[pixel] > 0. && half_of(pixel) == half; }

private:
    /// Noise of few bright samples is skewed. What a pixel has more than its surroundings is spread over pixels of its half, so that the
    /// mean stays and the halves know nothing of each other.
    void spread_spikes(Twicing const& rule, std::size_t half) {
        auto const pixels = value.size();
        std::vector<double> count(pixels);
        std::array<std::vector<double>, 3> excess{count, count, count};
        for (std::size_t i = 0; i < pixels; ++i) {
            if (!is_in(half, i)) continue;
            count[i] = 1.;
            double const square = product_of(value[i], value[i]);
            double const limit = static_cast<double>(rule.spike) * static_cast<double>(rule.spike) * mean_square[i];
            if (!(square > limit)) continue;
            auto const kept = value[i] * static_cast<float>(std::sqrt(limit / square));
            for (int c = 0; c < 3; ++c) excess[static_cast<std::size_t>(c)][i] = static_cast<double>(value[i][c] - kept[c]);
            value[i] = kept;
        }
        box_sums(size, count, rule.noise_radius);
        for (int c = 0; c < 3; ++c) {
            auto& spread = excess[static_cast<std::size_t>(c)];
            box_sums(size, spread, rule.noise_radius);
            for (std::size_t i = 0; i < pixels; ++i)
                if (is_in(half, i)) value[i][c] += static_cast<float>(spread[i] / count[i]);
        }
    }
};

/// What one band adds.
struct ResidualBand {
    std::vector<glm::vec3> value; ///< made of all samples
    std::vector<glm::vec3> held;  ///< made of samples of the other half
};

/// The residual's bands, the finest first.
template <Executor E>
std::array<ResidualBand, Twicing::bands> bands_of(Twicing const& rule, E const& executor, PictureResidual const& residual,
                                                  ViewOf<Planar<>, Normal> normal, ViewOf<Planar<>, Depth> depth) {
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
    std::array<ResidualBand, Twicing::bands> bands;
    for (int band = 0; band < Twicing::bands; ++band) {
        executor.for_each_pixel({0, 0, size.width, size.height}, SmoothResidual{.step = 1 << band,
                                                                                .per_depth_range = 1.f / rule.depth_range,
                                                                                .normal = normal,
                                                                                .depth = depth,
                                                                                .sum = {from[0].sum.view(), from[1].sum.view()},
                                                                                .to_sum = {to[0].sum.view(), to[1].sum.view()},
                                                                                .weight = {from[0].weight.view(), from[1].weight.view()},
                                                                                .to_weight = {to[0].weight.view(), to[1].weight.view()}});
        auto& made = bands[static_cast<std::size_t>(band)];
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
        std::swap(from, to);
    }
    for (std::size_t band = 0; band + 1 < bands.size(); ++band)
        for (std::size_t i = 0; i < pixels; ++i)
            bands[band].value[i] -= bands[band + 1].value[i], bands[band].held[i] -= bands[band + 1].held[i];
    return bands;
}

/// Takes a band's share of the residual into the picture and out of the residual.
inline void add_band(Twicing const& rule, ResidualBand const& band, PictureResidual& residual, std::vector<glm::vec3>& picture) {
    auto const size = residual.size;
    auto const pixels = picture.size();
    std::vector<double> products(pixels), squares(pixels), noise(pixels);
    double all_products = 0., all_squares = 0., all_noise = 0.;
    for (std::size_t i = 0; i < pixels; ++i) {
        if (!(residual.mean_square[i] > 0.)) continue;
        products[i] = product_of(residual.value[i], band.held[i]) / residual.mean_square[i];
        squares[i] = product_of(band.held[i], band.held[i]) / residual.mean_square[i];
        noise[i] = products[i] * products[i];
        all_products += products[i], all_squares += squares[i], all_noise += noise[i];
    }
    auto const sure_share = [](double product, double square, double variance, float deviations) {
        return square > 0. ? std::clamp((product - static_cast<double>(deviations) * std::sqrt(2. * variance)) / square, 0., 1.) : 0.;
    };
    auto shares = products; // of the larger windows
    {
        auto wide_squares = squares, wide_noise = noise;
        for (auto* const sums : {&shares, &wide_squares, &wide_noise}) box_sums(size, *sums, rule.wide_radius);
        double const everywhere = sure_share(all_products, all_squares, all_noise, rule.certainty);
        for (std::size_t i = 0; i < pixels; ++i)
            shares[i] = std::max(sure_share(shares[i], wide_squares[i], wide_noise[i], rule.wide_certainty), everywhere);
    }
    for (auto* const sums : {&products, &squares, &noise}) box_sums(size, *sums, rule.radius);
    // Each pair of pixels counts twice, which doubles the variance.
    auto& z = noise;
    std::vector<double> deviations(pixels);
    for (std::size_t i = 0; i < pixels; ++i) {
        deviations[i] = std::sqrt(2. * noise[i]);
        z[i] = deviations[i] > 0. ? products[i] / deviations[i] : 0.;
    }
    double const side = 2. * rule.radius + 1.;
    auto const threshold = threshold_above_noise(z, static_cast<double>(rule.false_share), 0.5 * side * side);
    for (std::size_t i = 0; i < pixels; ++i) {
        double share = shares[i];
        if (threshold && squares[i] > 0.) {
            double const here = (products[i] - static_cast<double>(rule.shrinkage) * *threshold * deviations[i]) / squares[i];
            double const sure = std::clamp((z[i] / *threshold - .7) / .3, 0., 1.);
            share = std::max(share, std::clamp(here, 0., 1.) * sure);
        }
        auto const part = static_cast<float>(share);
        picture[i] += part * band.value[i], residual.value[i] -= part * band.held[i];
    }
}
} // namespace detail

/// Adds to a picture what its samples tell that it lacks (Twicing).
/// @param rule     how
/// @param executor runs the passes
/// @param samples  that the picture was made of, linear, row by row; not finite where there is none
/// @param normal   a view of the surfaces' directions, of any length; zero: none
/// @param depth    a view of their distances; infinite: none
/// @param picture  the denoised one; is changed
/// @throws std::bad_alloc
template <Executor E>
void add_back_residual(Twicing const& rule, E const& executor, std::vector<glm::vec3> const& samples, ViewOf<Planar<>, Normal> normal,
                       ViewOf<Planar<>, Depth> depth, std::vector<glm::vec3>& picture) {
    detail::PictureResidual residual(rule, depth.size, samples, picture);
    auto const bands = detail::bands_of(rule, executor, residual, normal, depth);
    auto const before = picture;
    for (std::size_t band = bands.size(); band-- > 0;) detail::add_band(rule, bands[band], residual, picture);
    for (std::size_t i = 0; i < picture.size(); ++i)
        for (int c = 0; c < 3; ++c)
            if (before[i][c] >= 0.f) picture[i][c] = std::max(picture[i][c], 0.f);
}

} // namespace quell::inline QUELL_INSTRUCTION_SET
