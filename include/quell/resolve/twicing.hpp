#pragma once

#include <quell/resolve/residual_bands.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

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
    int radius = 6;             ///< of the windows, in pixels
    int wide_radius = 30;       ///< of the larger ones
    float false_share = 0.2f;   ///< of windows taken, how many may be noise
    float shrinkage = 0.3f;     ///< part of the threshold that is taken off the sums
    float wide_certainty = 3.f; ///< standard deviations taken off the sums over larger windows
    float certainty = 2.f;      ///< standard deviations taken off the sums over all the image
    float depth_range = 0.05f;  ///< part by which depths of one surface differ
    ResidualLimits limits{};    ///< of the residual
};

namespace detail {

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

/// Sums over windows of what a band has to do with the residual: terms of each pixel at first.
struct BandSums {
    std::vector<double> products; ///< of the residual and the band that was made of the other half
    std::vector<double> squares;  ///< of that band
    std::vector<double> noise;    ///< squared products: the variance of their sum is twice theirs, as each pair of pixels counts twice

    explicit BandSums(std::size_t pixels) : products(pixels), squares(pixels), noise(pixels) {}
    BandSums(ResidualBand const& band, PictureResidual const& residual) : BandSums(residual.value.size()) {
        for (std::size_t i = 0; i < products.size(); ++i) {
            if (!(residual.mean_square[i] > 0.)) continue;
            products[i] = product_of(residual.value[i], band.held[i]) / residual.mean_square[i];
            squares[i] = product_of(band.held[i], band.held[i]) / residual.mean_square[i];
            noise[i] = products[i] * products[i];
        }
    }
    /// The same over the square around each pixel.
    [[nodiscard]] BandSums around(Extent size, int radius) const {
        auto sums = *this;
        for (auto* const each : {&sums.products, &sums.squares, &sums.noise}) box_sums(size, *each, radius);
        return sums;
    }
    /// The same over all pixels: of one.
    [[nodiscard]] BandSums everywhere() const {
        BandSums sums(1);
        for (std::size_t i = 0; i < products.size(); ++i)
            sums.products[0] += products[i], sums.squares[0] += squares[i], sums.noise[0] += noise[i];
        return sums;
    }
    /// Standard deviation of a pixel's sum of products, were all of them noise.
    [[nodiscard]] double deviation(std::size_t i) const { return std::sqrt(2. * noise[i]); }
    /// The share of the band that is sure to be there.
    /// @param certainty standard deviations that are taken off
    [[nodiscard]] double sure_share(std::size_t i, double certainty) const {
        return squares[i] > 0. ? std::clamp((products[i] - certainty * deviation(i)) / squares[i], 0., 1.) : 0.;
    }
    /// The sums of products in standard deviations.
    [[nodiscard]] std::vector<double> in_deviations() const {
        std::vector<double> z(products.size());
        for (std::size_t i = 0; i < z.size(); ++i)
            if (double const its = deviation(i); its > 0.) z[i] = products[i] / its;
        return z;
    }
};

/// Takes a band's share of the residual into the picture and out of the residual.
inline void add_band(Twicing const& rule, ResidualBand const& band, PictureResidual& residual, std::vector<glm::vec3>& picture) {
    BandSums const of_pixels(band, residual);
    double const everywhere = of_pixels.everywhere().sure_share(0, static_cast<double>(rule.certainty));
    auto const wide = of_pixels.around(residual.size, rule.wide_radius), narrow = of_pixels.around(residual.size, rule.radius);
    auto const z = narrow.in_deviations();
    double const side = 2. * rule.radius + 1.;
    auto const threshold = threshold_above_noise(z, static_cast<double>(rule.false_share), 0.5 * side * side);
    for (std::size_t i = 0; i < picture.size(); ++i) {
        double share = std::max(wide.sure_share(i, static_cast<double>(rule.wide_certainty)), everywhere);
        if (threshold) {
            double const sure = std::clamp((z[i] / *threshold - .7) / .3, 0., 1.);
            share = std::max(share, narrow.sure_share(i, static_cast<double>(rule.shrinkage) * *threshold) * sure);
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
/// @throws Error where these are not of one size, std::bad_alloc
template <Executor E>
void add_back_residual(Twicing const& rule, E const& executor, std::vector<glm::vec3> const& samples, ViewOf<Planar<>, Normal> normal,
                       ViewOf<Planar<>, Depth> depth, std::vector<glm::vec3>& picture) {
    detail::check_residual_sizes("add_back_residual", samples, normal.size, depth.size, picture);
    detail::PictureResidual residual(rule.limits, depth.size, samples, picture);
    auto const bands = detail::bands_of(executor, residual, {normal, depth, rule.depth_range});
    auto const before = picture;
    for (std::size_t band = bands.size(); band-- > 0;) detail::add_band(rule, bands[band], residual, picture);
    for (std::size_t i = 0; i < picture.size(); ++i)
        for (int c = 0; c < 3; ++c)
            if (before[i][c] >= 0.f) picture[i][c] = std::max(picture[i][c], 0.f);
}

} // namespace quell::inline QUELL_INSTRUCTION_SET
