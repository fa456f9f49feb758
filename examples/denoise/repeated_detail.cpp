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
std::vector<double> light_around(metrics::Picture const& picture) {
    float const unit = quell::detail::light_unit(picture.pixels);
    auto const planes = quell::detail::in_planes(picture.size, picture.pixels, unit);
    quell::detail::WindowSums<1> sums(picture.size);
    auto const around = quell::detail::light_around(Simd{}, sums, quell::detail::Brightness(Simd{}, planes.view()));
    std::vector<double> light;
    for (int y = 0; y < picture.size.height; ++y)
        for (int x = 0; x < picture.size.width; ++x) light.push_back(static_cast<double>(around.get(x, y) * unit));
    return light;
}

} // namespace

metrics::Picture finest_detail(RepeatedDetail const& rule, metrics::Picture picture) {
    for (auto& pixel : picture.pixels)
        if (!is_finite(pixel.x) || !is_finite(pixel.y) || !is_finite(pixel.z)) pixel = glm::vec3(0.f);
    auto const planes = quell::detail::in_planes(picture.size, picture.pixels);
    auto wider = picture.pixels;
    quell::detail::copy_out(quell::detail::blurred(Simd{}, planes.view(), rule.deviation).view(), wider);
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) picture.pixels[i] -= wider[i];
    return picture;
}

metrics::Picture detail_of_colour(RepeatedDetail const& rule, metrics::Picture const& colour, metrics::Picture const& signal) {
    constexpr double darkest = 1e-4; // of a colour
    auto detail = finest_detail(rule, colour);
    auto const pixels = colour.pixels.size();
    for (int c = 0; c < 3; ++c) {
        std::vector<double> colours(pixels), lights(pixels);
        for (std::size_t i = 0; i < pixels; ++i)
            if (is_finite(colour.pixels[i][c]) && is_finite(signal.pixels[i][c]))
                colours[i] = static_cast<double>(colour.pixels[i][c]), lights[i] = static_cast<double>(signal.pixels[i][c]);
        box_sums(colour.size, colours, rule.light_radius), box_sums(colour.size, lights, rule.light_radius);
        for (std::size_t i = 0; i < pixels; ++i) detail.pixels[i][c] *= static_cast<float>(lights[i] / std::max(colours[i], darkest));
    }
    return detail;
}

void limit_detail(RepeatedDetail const& rule, metrics::Picture const& picture, metrics::Picture& detail) {
    auto const light = light_around(picture);
    for (std::size_t i = 0; i < detail.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            float const most = rule.most * static_cast<float>(light[i]);
            float& value = detail.pixels[i][c];
            value = is_finite(value) ? std::clamp(value, -most, most) : 0.f;
        }
}

std::vector<float> share_of_guides(RepeatedDetail const& rule, metrics::Picture const& detail, metrics::Picture const& guides,
                                   metrics::Picture const& picture) {
    auto const size = detail.size;
    auto const light = light_around(picture);
    std::vector<double> common(light.size()), square(light.size()), square_of_guides(light.size());
    for (std::size_t i = 0; i < light.size(); ++i) {
        double const per_light = 1. / (light[i] * light[i]);
        common[i] = product_of(detail.pixels[i], guides.pixels[i]) * per_light;
        square[i] = product_of(detail.pixels[i], detail.pixels[i]) * per_light;
        square_of_guides[i] = product_of(guides.pixels[i], guides.pixels[i]) * per_light;
    }
    for (auto* const each : {&common, &square, &square_of_guides}) box_sums(size, *each, rule.radius);
    std::vector<float> shares(light.size(), 0.f);
    for (std::size_t i = 0; i < shares.size(); ++i)
        if (double const product = square[i] * square_of_guides[i]; product > 0.)
            shares[i] = static_cast<float>(std::clamp(static_cast<double>(rule.alike) * common[i] / std::sqrt(product), 0., 1.));
    return shares;
}

std::vector<float> repeated_share(RepeatedDetail const& rule, metrics::Picture const& detail, metrics::Picture const& picture,
                                  ViewOf<Planar<>, Motion> motion, metrics::Picture const& before) {
    std::vector<float> shares(detail.pixels.size(), 1.f);
    if (before.pixels.size() != detail.pixels.size()) return shares;
    auto const size = detail.size;
    auto const light = light_around(picture);
    auto const before_here = quell::detail::moved(Simd{}, before.pixels, motion, glm::vec3(0.f));
    std::vector<double> common(shares.size()), square(shares.size());
    for (std::size_t i = 0; i < shares.size(); ++i) {
        double const per_light = 1. / (light[i] * light[i]);
        common[i] = product_of(detail.pixels[i], before_here[i]) * per_light;
        square[i] = product_of(before_here[i], before_here[i]) * per_light;
    }
    box_sums(size, common, rule.radius), box_sums(size, square, rule.radius);
    for (std::size_t i = 0; i < shares.size(); ++i)
        if (square[i] > 0.) shares[i] = static_cast<float>(std::clamp(common[i] / square[i], 0., 1.));
    return shares;
}

} // namespace quell::examples
