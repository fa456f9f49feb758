#pragma once

#include <quell/core/real.hpp>
#include <quell/frame/channels.hpp>
#include <quell/image/planar.hpp>
#include <quell/resolve/residual.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Gives back to a denoised picture what frames in a row lack. Noise of samples is new in each frame, but what a filter takes out by
/// mistake, such as leaves smaller than a pixel or reflections, is lacking again where their surface has moved to. So what the residual
/// (samples minus picture) of this frame has in common with those of the frames before and after, over a window, is a measure of that
/// mistake, whatever the noise is.
///
/// All residuals are split into three bands, and those of the frames around, where their surfaces are now, are put together as their mean.
/// For each band, over a window, c is the sum of the product of this residual and that mean, less its standard error times `caution`; v and
/// u are the sums of their squares, and w is the mean of the sums of squares of each frame around: its noise is not less for the mean. The
/// mistake that is in the residual of now is b = c v / w, at least c: moving residuals between pixels takes as much off c as off w where
/// detail is finer than pixels. What is added is x now + y mean, with the least expected error: v x + c y = b and c x + u y = c.
///
/// Where a pixel holds fewer samples, more of what the finest band repeats is no mistake: a single sample sees the same point of a leaf
/// again, wherever in its pixel that lies, and a picture of such points is jagged. Of that band a part of 1 / samples is left out. And
/// noise of few samples is skewed, so that by chance more of it is alike: caution is 1 + 2 / samples times as large.
struct RepeatedResidual {
    float samples = 1.f;                         ///< of each pixel
    std::array<float, 2> deviation{0.7f, 2.f};   ///< of the Gaussians between the bands, in pixels
    std::array<int, 3> radius{8, 10, 16};        ///< of each band's windows, in pixels
    std::array<float, 3> caution{.7f, 1.f, 2.f}; ///< more for wider bands, whose neighbouring pixels hold the same noise
    float most = 20.f;                           ///< a residual is at most so many times the light around
    float darkest = 0.2f;                        ///< of the picture's light so much stays at least
};

namespace detail {

using ResidualImage = std::vector<glm::vec3>;

/// Means by a Gaussian, over what lies in the image.
inline ResidualImage blurred(Extent size, ResidualImage const& image, float deviation) {
    int const radius = static_cast<int>(std::ceil(3.f * deviation));
    std::vector<float> weights(static_cast<std::size_t>(radius) + 1);
    for (std::size_t i = 0; i < weights.size(); ++i) weights[i] = std::exp(-0.5f * static_cast<float>(i * i) / (deviation * deviation));
    auto const along = [&](ResidualImage const& from, int lines, int length, std::size_t line_step, std::size_t step) {
        ResidualImage to(from.size());
        for (int line = 0; line < lines; ++line)
            for (int i = 0; i < length; ++i) {
                auto const first = static_cast<std::size_t>(line) * line_step;
                glm::vec3 sum(0.f);
                float whole = 0.f;
                for (int j = std::max(i - radius, 0); j <= std::min(i + radius, length - 1); ++j) {
                    float const weight = weights[static_cast<std::size_t>(std::abs(j - i))];
                    sum += weight * from[first + static_cast<std::size_t>(j) * step], whole += weight;
                }
                to[first + static_cast<std::size_t>(i) * step] = sum / whole;
            }
        return to;
    };
    auto const width = static_cast<std::size_t>(size.width);
    return along(along(image, size.height, size.width, width, 1), size.width, size.height, 1, width);
}

/// What an image of the frame before, or after, is where its surfaces are now, between its pixels.
/// @param motion    a view of where each surface is in that frame, less where it is now
/// @param elsewhere where they are not in the image
inline ResidualImage moved(ResidualImage const& before, ImageView auto motion, glm::vec3 const& elsewhere = glm::vec3(0.f)) {
    auto const size = motion.size;
    ResidualImage now(before.size(), elsewhere);
    std::size_t i = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x, ++i) {
            float const column = static_cast<float>(x) + motion.get(0, x, y), row = static_cast<float>(y) + motion.get(1, x, y);
            bool const inside = column > -0.5f && column < static_cast<float>(size.width) - 0.5f && row > -0.5f &&
                                row < static_cast<float>(size.height) - 0.5f;
            if (!is_finite(column) || !is_finite(row) || !inside) continue;
            float const left = std::floor(column), top = std::floor(row);
            now[i] = glm::vec3(0.f);
            for (int down = 0; down < 2; ++down)
                for (int right = 0; right < 2; ++right) {
                    auto const there = [](float first, int more, int length) {
                        return static_cast<std::size_t>(std::clamp(static_cast<int>(first) + more, 0, length - 1));
                    };
                    float const weight = std::abs(1.f - static_cast<float>(right) - (column - left)) *
                                         std::abs(1.f - static_cast<float>(down) - (row - top));
                    now[i] += weight *
                              before[there(top, down, size.height) * static_cast<std::size_t>(size.width) + there(left, right, size.width)];
                }
        }
    return now;
}

/// A residual of a frame before or after, where its surfaces are now.
struct ResidualAround {
    ResidualImage value;        ///< 0 where it is not known
    std::vector<bool> is_known; ///< of each pixel
};

/// Values are at most so many times the light; what is not finite becomes 0.
inline void limit_residual(std::vector<double> const& light, float times, ResidualImage& residual) {
    for (std::size_t i = 0; i < residual.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            float const most = times * static_cast<float>(light[i]);
            residual[i][c] = is_finite(residual[i][c]) ? std::clamp(residual[i][c], -most, most) : 0.f;
        }
}

/// What is finer than a Gaussian; the rest stays.
inline ResidualImage take_finer(Extent size, ResidualImage const& whole, float deviation, ResidualImage& rest) {
    auto wider = blurred(size, whole, deviation), finer = std::move(rest);
    for (std::size_t i = 0; i < finer.size(); ++i) finer[i] -= wider[i];
    rest = std::move(wider);
    return finer;
}

/// Adds to a picture what one band of all residuals tells that it lacks.
inline void add_repeated(Extent size, ResidualImage const& now, std::vector<ResidualAround> const& around, std::vector<double> const& light,
                         int radius, float caution, float part, ResidualImage& picture) {
    ResidualImage mean(now.size(), glm::vec3(0.f));
    std::vector<double> common(now.size()), error(now.size()), square(now.size()), square_mean(now.size()), square_each(now.size());
    for (std::size_t i = 0; i < now.size(); ++i) {
        double const per_light = 1. / (light[i] * light[i]);
        float known = 0.f;
        for (auto const& each : around) {
            if (!each.is_known[i]) continue;
            mean[i] += each.value[i], known += 1.f;
            square_each[i] += product_of(each.value[i], each.value[i]) * per_light;
        }
        if (known > 1.f) mean[i] /= known, square_each[i] /= static_cast<double>(known);
        common[i] = product_of(now[i], mean[i]) * per_light, error[i] = common[i] * common[i];
        square[i] = product_of(now[i], now[i]) * per_light, square_mean[i] = product_of(mean[i], mean[i]) * per_light;
    }
    for (auto* const each : {&common, &error, &square, &square_mean, &square_each}) box_sums(size, *each, radius);
    for (std::size_t i = 0; i < now.size(); ++i) {
        double const v = std::max(square[i], 0.), u = std::max(square_mean[i], 0.), w = std::max(square_each[i], u);
        double const sure = common[i] - static_cast<double>(caution) * std::sqrt(std::max(error[i], 0.));
        double const c = std::min({sure, u, v, .98 * std::sqrt(u * v)});
        if (!(c > 0.)) continue;
        double const determinant = v * u - c * c, b = std::max(c * v / w, c);
        double const x = std::clamp((b * u - c * c) / determinant, 0., 1.), y = std::clamp(c * (v - b) / determinant, 0., 1. - x);
        picture[i] += part * (static_cast<float>(x) * now[i] + static_cast<float>(y) * mean[i]);
    }
}

} // namespace detail

/// What a picture lacks of its samples (RepeatedResidual): these minus the picture, within limits, and 0 where there is no sample.
/// @param samples that the picture was made of, linear, row by row; not finite where there is none
/// @throws Error where these are not of one size, std::bad_alloc
[[nodiscard]] inline std::vector<glm::vec3> lacking_of_samples(RepeatedResidual const& rule, Extent size,
                                                               std::vector<glm::vec3> const& samples,
                                                               std::vector<glm::vec3> const& picture) {
    detail::check_residual_sizes("lacking_of_samples", samples, size, size, picture);
    std::vector<glm::vec3> residual(samples.size());
    for (std::size_t i = 0; i < residual.size(); ++i)
        residual[i] = detail::is_light(vec3<float>(samples[i])) ? samples[i] - picture[i] : glm::vec3(0.f);
    detail::limit_residual(detail::light_around(size, picture), rule.most, residual);
    return residual;
}

/// What the picture of a frame before or after lacks, where its surfaces are now; not finite where that is not known.
/// @param lacking of that frame: what lacking_of_samples() says
/// @param motion  a view of where each surface is in that frame, less where it is now, in pixels; not finite: unknown
/// @throws Error where these are not of one size, std::bad_alloc
[[nodiscard]] inline std::vector<glm::vec3> lacking_moved(std::vector<glm::vec3> const& lacking, ImageView auto motion) {
    detail::check_residual_sizes("lacking_moved", lacking, motion.size, motion.size, lacking);
    return detail::moved(lacking, motion, glm::vec3(std::numeric_limits<float>::quiet_NaN()));
}

/// Adds to a picture what it and the pictures of frames around lack (RepeatedResidual). Where there are none, it stays as it is.
/// @param rule    how
/// @param lacking of the picture: what lacking_of_samples() says
/// @param around  what lacking_moved() says of the frame before, of that after, or of both
/// @param picture the denoised one; is changed
/// @throws Error where these are not of one size, std::bad_alloc
inline void give_back_repeated(RepeatedResidual const& rule, Extent size, std::vector<glm::vec3> const& lacking,
                               std::vector<std::vector<glm::vec3>> const& around, std::vector<glm::vec3>& picture) {
    using namespace detail;
    check_residual_sizes("give_back_repeated", lacking, size, size, picture);
    for (auto const& each : around) check_residual_sizes("give_back_repeated, a frame around", each, size, size, picture);
    if (around.empty()) return;
    auto const light = light_around(size, picture);
    std::vector<ResidualAround> whole_around;
    for (auto const& each : around) {
        whole_around.push_back({each, std::vector<bool>(each.size())});
        for (std::size_t i = 0; i < each.size(); ++i) whole_around.back().is_known[i] = is_finite(each[i].x);
        limit_residual(light, rule.most, whole_around.back().value);
    }
    auto rest_around = whole_around;
    auto rest = lacking;
    std::vector<glm::vec3> off(picture.size(), glm::vec3(0.f));
    float const per_samples = 1.f / std::max(rule.samples, 1.f);
    auto const add = [&](ResidualImage const& now, std::vector<ResidualAround> const& then, std::size_t band) {
        add_repeated(size, now, then, light, rule.radius[band], rule.caution[band] * (1.f + 2.f * per_samples),
                     band == 0 ? 1.f - per_samples : 1.f, off);
    };
    for (std::size_t band = 0; band < rule.deviation.size(); ++band) {
        auto const now = take_finer(size, lacking, rule.deviation[band], rest);
        std::vector<ResidualAround> then;
        for (std::size_t k = 0; k < rest_around.size(); ++k)
            then.push_back({take_finer(size, whole_around[k].value, rule.deviation[band], rest_around[k].value), rest_around[k].is_known});
        add(now, then, band);
    }
    add(rest, rest_around, rule.deviation.size());
    for (std::size_t i = 0; i < picture.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            float const old = picture[i][c], made = old + off[i][c];
            if (is_finite(made)) picture[i][c] = std::max(made, std::min(old, rule.darkest * old));
        }
}

} // namespace quell::inline QUELL_INSTRUCTION_SET
