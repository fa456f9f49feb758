#include <denoise/repeated_detail.hpp>

#include <quell/core/value.hpp>
#include <quell/execute/executor.hpp>
#include <quell/resolve/box_sums.hpp>
#include <quell/resolve/gaussian_blur.hpp>
#include <quell/resolve/moved_image.hpp>
#include <quell/resolve/picture_brightness.hpp>

#include <algorithm>
#include <cmath>

namespace quell::examples {

namespace {

double product_of(glm::vec3 const& a, glm::vec3 const& b) { return static_cast<double>(dot(vec3<float>(a), vec3<float>(b))); }

/// The light of a picture around each pixel.
std::vector<double> light_around(LinearView const& picture) {
    float const unit = quell::detail::light_unit(picture);
    auto const planes = quell::detail::in_planes(picture, unit);
    quell::detail::WindowSums<1> sums(picture.size);
    auto const around = quell::detail::light_around(Simd{}, sums, quell::detail::Brightness(Simd{}, planes.view()));
    std::vector<double> light;
    for (int y = 0; y < picture.size.height; ++y)
        for (int x = 0; x < picture.size.width; ++x) light.push_back(static_cast<double>(around.get(x, y) * unit));
    return light;
}

} // namespace

LinearPicture finest_detail(RepeatedDetail const& rule, LinearView const& given) {
    LinearPicture picture(given.size);
    for (std::size_t i = 0; i < picture.pixels(); ++i)
        if (all_finite(given[i])) picture[i] = given[i];
    auto const planes = quell::detail::in_planes(picture.view());
    auto const wider = quell::detail::blurred(Simd{}, planes.view(), rule.deviation);
    for (int c = 0; c < 3; ++c)
        for (int y = 0; y < given.size.height; ++y)
            for (int x = 0; x < given.size.width; ++x) picture.at(c, index_of(given.size, x, y)) -= wider.view().get(c, x, y);
    return picture;
}

LinearPicture detail_of_colour(RepeatedDetail const& rule, LinearView const& colour, LinearView const& signal) {
    constexpr double darkest = 1e-4; // of a colour
    auto detail = finest_detail(rule, colour);
    auto const pixels = colour.pixels();
    for (int c = 0; c < 3; ++c) {
        std::vector<double> colours(pixels), lights(pixels);
        for (std::size_t i = 0; i < pixels; ++i)
            if (is_finite(colour.at(c, i)) && is_finite(signal.at(c, i)))
                colours[i] = static_cast<double>(colour.at(c, i)), lights[i] = static_cast<double>(signal.at(c, i));
        box_sums(colour.size, colours, rule.light_radius), box_sums(colour.size, lights, rule.light_radius);
        for (std::size_t i = 0; i < pixels; ++i) detail.at(c, i) *= static_cast<float>(lights[i] / std::max(colours[i], darkest));
    }
    return detail;
}

void limit_detail(RepeatedDetail const& rule, LinearView const& picture, LinearPicture& detail) {
    auto const light = light_around(picture);
    for (std::size_t i = 0; i < detail.pixels(); ++i)
        for (int c = 0; c < 3; ++c) {
            float const most = rule.most * static_cast<float>(light[i]);
            float& value = detail.at(c, i);
            value = is_finite(value) ? std::clamp(value, -most, most) : 0.f;
        }
}

std::vector<float> share_of_guides(RepeatedDetail const& rule, LinearView const& detail, LinearView const& guides,
                                   LinearView const& picture) {
    auto const size = detail.size;
    auto const light = light_around(picture);
    std::vector<double> common(light.size()), square(light.size()), square_of_guides(light.size());
    for (std::size_t i = 0; i < light.size(); ++i) {
        double const per_light = 1. / (light[i] * light[i]);
        common[i] = product_of(detail[i], guides[i]) * per_light;
        square[i] = product_of(detail[i], detail[i]) * per_light;
        square_of_guides[i] = product_of(guides[i], guides[i]) * per_light;
    }
    for (auto* const each : {&common, &square, &square_of_guides}) box_sums(size, *each, rule.radius);
    std::vector<float> shares(light.size(), 0.f);
    for (std::size_t i = 0; i < shares.size(); ++i)
        if (double const product = square[i] * square_of_guides[i]; product > 0.)
            shares[i] = static_cast<float>(std::clamp(static_cast<double>(rule.alike) * common[i] / std::sqrt(product), 0., 1.));
    return shares;
}

std::vector<float> repeated_share(RepeatedDetail const& rule, LinearView const& detail, LinearView const& picture,
                                  ViewOf<Planar<>, Motion> motion, LinearView const& before) {
    std::vector<float> shares(detail.pixels(), 1.f);
    if (before.pixels() != detail.pixels()) return shares;
    auto const size = detail.size;
    auto const light = light_around(picture);
    auto const before_here = quell::detail::moved(Simd{}, before, motion, glm::vec3(0.f));
    std::vector<double> common(shares.size()), square(shares.size());
    for (std::size_t i = 0; i < shares.size(); ++i) {
        double const per_light = 1. / (light[i] * light[i]);
        common[i] = product_of(detail[i], before_here[i]) * per_light;
        square[i] = product_of(before_here[i], before_here[i]) * per_light;
    }
    box_sums(size, common, rule.radius), box_sums(size, square, rule.radius);
    for (std::size_t i = 0; i < shares.size(); ++i)
        if (square[i] > 0.) shares[i] = static_cast<float>(std::clamp(common[i] / square[i], 0., 1.));
    return shares;
}

} // namespace quell::examples
