#pragma once

#include <quell/core/real.hpp>
#include <quell/frame/channels.hpp>
#include <quell/image/planar.hpp>
#include <quell/resolve/residual.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Gives back to a denoised picture what two frames in a row lack. Noise of samples is new in each frame, but what a filter takes out by
/// mistake, such as leaves smaller than a pixel or reflections, is lacking again where their surface has moved to. So what the residuals
/// (samples minus picture) of both frames have in common over a window is a measure of that mistake, whatever the noise is.
///
/// Both residuals are split into three bands. For each, over a window, c is the sum of the product of both, less its standard error times
/// `caution`; v and u are the sums of their squares. The mistake that is in the residual of now is b = c v / u, at least c: moving the
/// residual before between pixels takes as much off c as off u where detail is finer than pixels. What is added is x now + y before, with
/// the least expected error: v x + c y = b and c x + u y = c.
///
/// Where a pixel holds fewer samples, more of what the finest band repeats is no mistake: a single sample sees the same point of a leaf
/// again, wherever in its pixel that lies, and a picture of such points is jagged. Of that band a part of 1 / samples is left out. And
/// noise of few samples is skewed, so that by chance more of it is alike: caution is 1 + 1 / samples times as large.
struct RepeatedResidual {
    float samples = 1.f;                          ///< of each pixel
    std::array<float, 2> deviation{0.7f, 2.f};    ///< of the Gaussians between the bands, in pixels
    std::array<int, 3> radius{8, 10, 16};         ///< of each band's windows, in pixels
    std::array<float, 3> caution{1.f, 1.5f, 3.f}; ///< more for wider bands, whose neighbouring pixels hold the same noise
    float most = 20.f;                            ///< a residual is at most so many times the light around
    float darkest = 0.2f;                         ///< of the picture's light so much stays at least
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

/// What a residual of the frame before is where its surfaces are now, between its pixels; 0 where they were not in the image.
inline ResidualImage moved(ResidualImage const& before, ViewOf<Planar<>, Motion> motion) {
    auto const size = motion.size;
    ResidualImage now(before.size(), glm::vec3(0.f));
    std::size_t i = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x, ++i) {
            float const column = static_cast<float>(x) + motion.get(0, x, y), row = static_cast<float>(y) + motion.get(1, x, y);
            bool const inside = column > -0.5f && column < static_cast<float>(size.width) - 0.5f && row > -0.5f &&
                                row < static_cast<float>(size.height) - 0.5f;
            if (!is_finite(column) || !is_finite(row) || !inside) continue;
            float const left = std::floor(column), top = std::floor(row);
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

/// Adds to a picture what one band of both residuals tells that it lacks.
inline void add_repeated(Extent size, ResidualImage const& now, ResidualImage const& before, std::vector<double> const& light, int radius,
                         float caution, float part, ResidualImage& picture) {
    std::vector<double> common(now.size()), error(now.size()), square(now.size()), square_before(now.size());
    for (std::size_t i = 0; i < now.size(); ++i) {
        double const per_light = 1. / (light[i] * light[i]);
        common[i] = product_of(now[i], before[i]) * per_light, error[i] = common[i] * common[i];
        square[i] = product_of(now[i], now[i]) * per_light, square_before[i] = product_of(before[i], before[i]) * per_light;
    }
    for (auto* const each : {&common, &error, &square, &square_before}) box_sums(size, *each, radius);
    for (std::size_t i = 0; i < now.size(); ++i) {
        double const v = std::max(square[i], 0.), u = std::max(square_before[i], 0.);
        double const sure = common[i] - static_cast<double>(caution) * std::sqrt(std::max(error[i], 0.));
        double const c = std::min({sure, u, v, .98 * std::sqrt(u * v)});
        if (!(c > 0.)) continue;
        double const determinant = v * u - c * c, b = std::max(c * v / u, c);
        double const x = std::clamp((b * u - c * c) / determinant, 0., 1.), y = std::clamp(c * (v - b) / determinant, 0., 1. - x);
        picture[i] += part * (static_cast<float>(x) * now[i] + static_cast<float>(y) * before[i]);
    }
}

} // namespace detail

/// Adds to a picture what it and the picture of the frame before lack (RepeatedResidual).
/// @param rule    how
/// @param samples that the picture was made of, linear, row by row; not finite where there is none
/// @param motion  a view of where each surface was in the frame before, less where it is, in pixels; not finite: unknown
/// @param before  what this returned for the frame before; empty: there was none, and the picture stays as it is
/// @param picture the denoised one; is changed
/// @return this frame's residual: what the picture that was given lacks of its samples
/// @throws Error where these are not of one size, std::bad_alloc
inline std::vector<glm::vec3> give_back_repeated(RepeatedResidual const& rule, std::vector<glm::vec3> const& samples,
                                                 ViewOf<Planar<>, Motion> motion, std::vector<glm::vec3> const& before,
                                                 std::vector<glm::vec3>& picture) {
    using namespace detail;
    auto const size = motion.size;
    check_residual_sizes("give_back_repeated", samples, size, size, picture);
    if (!before.empty()) check_residual_sizes("give_back_repeated, the frame before", before, size, size, picture);
    auto const light = light_around(size, picture);
    auto const limited = [&](std::vector<glm::vec3>& residual) {
        for (std::size_t i = 0; i < residual.size(); ++i)
            for (int c = 0; c < 3; ++c) {
                float const most = rule.most * static_cast<float>(light[i]);
                residual[i][c] = is_finite(residual[i][c]) ? std::clamp(residual[i][c], -most, most) : 0.f;
            }
    };
    std::vector<glm::vec3> residual(samples.size());
    for (std::size_t i = 0; i < residual.size(); ++i)
        residual[i] = is_light(vec3<float>(samples[i])) ? samples[i] - picture[i] : glm::vec3(0.f);
    limited(residual);
    if (before.empty()) return residual;
    auto before_here = moved(before, motion);
    limited(before_here);
    auto rest = residual, rest_before = before_here;
    std::vector<glm::vec3> off(picture.size(), glm::vec3(0.f));
    float const per_samples = 1.f / std::max(rule.samples, 1.f);
    auto const add = [&](std::vector<glm::vec3> const& now, std::vector<glm::vec3> const& then, std::size_t band) {
        add_repeated(size, now, then, light, rule.radius[band], rule.caution[band] * (1.f + per_samples),
                     band == 0 ? 1.f - per_samples : 1.f, off);
    };
    for (std::size_t band = 0; band < rule.deviation.size(); ++band) {
        auto wider = blurred(size, residual, rule.deviation[band]), wider_before = blurred(size, before_here, rule.deviation[band]);
        for (std::size_t i = 0; i < rest.size(); ++i) rest[i] -= wider[i], rest_before[i] -= wider_before[i];
        add(rest, rest_before, band);
        rest = std::move(wider), rest_before = std::move(wider_before);
    }
    add(rest, rest_before, rule.deviation.size());
    for (std::size_t i = 0; i < picture.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            float const old = picture[i][c], made = old + off[i][c];
            if (is_finite(made)) picture[i][c] = std::max(made, std::min(old, rule.darkest * old));
        }
    return residual;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET
