#include <denoise/repeated_detail.hpp>

#include <quell/resolve/repeated_residual.hpp>
#include <quell/resolve/residual.hpp>

#include <algorithm>

namespace quell::examples {

metrics::Picture finest_detail(RepeatedDetail const& rule, metrics::Picture picture) {
    for (auto& pixel : picture.pixels)
        if (!is_finite(pixel.x) || !is_finite(pixel.y) || !is_finite(pixel.z)) pixel = glm::vec3(0.f);
    auto const wider = quell::detail::blurred(picture.size, picture.pixels, rule.deviation);
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) picture.pixels[i] -= wider[i];
    return picture;
}

metrics::Picture detail_of_guides(RepeatedDetail const& rule, std::vector<ColouredSignal> signals, metrics::Picture const& added,
                                  metrics::Picture const& picture) {
    constexpr double darkest = 1e-4; // of a colour
    auto const size = picture.size;
    auto const pixels = picture.pixels.size();
    metrics::Picture detail{size, std::vector<glm::vec3>(pixels, glm::vec3(0.f))};
    auto const sums_of = [&](metrics::Picture const& image, int c, metrics::Picture const& where) {
        std::vector<double> values(pixels);
        for (std::size_t i = 0; i < pixels; ++i)
            if (is_finite(image.pixels[i][c]) && is_finite(where.pixels[i][c])) values[i] = static_cast<double>(image.pixels[i][c]);
        box_sums(size, values, rule.light_radius);
        return values;
    };
    std::vector<metrics::Picture> details;
    for (auto& signal : signals) {
        limit_detail(rule, picture, signal.product); // of few bright samples
        details.push_back(finest_detail(rule, signal.colour));
    }
    for (int c = 0; c < 3; ++c) {
        std::vector<double> whole(pixels);
        for (std::size_t s = 0; s < signals.size(); ++s) {
            auto const& [colour, product] = signals[s];
            auto const colours = sums_of(colour, c, product), lights = sums_of(product, c, colour);
            for (std::size_t i = 0; i < pixels; ++i) {
                detail.pixels[i][c] += details[s].pixels[i][c] * static_cast<float>(lights[i] / std::max(colours[i], darkest));
                whole[i] += lights[i];
            }
        }
        auto wanted = sums_of(picture, c, picture);
        if (!added.pixels.empty()) {
            auto const taken = sums_of(added, c, added);
            for (std::size_t i = 0; i < pixels; ++i) wanted[i] -= taken[i];
        }
        double const most = static_cast<double>(rule.most_scale);
        for (std::size_t i = 0; i < pixels; ++i)
            if (whole[i] > 0.) detail.pixels[i][c] *= static_cast<float>(std::clamp(wanted[i] / whole[i], 1. / most, most));
    }
    if (!added.pixels.empty()) {
        auto const own = finest_detail(rule, added);
        for (std::size_t i = 0; i < pixels; ++i) detail.pixels[i] += own.pixels[i];
    }
    limit_detail(rule, picture, detail);
    return detail;
}

void limit_detail(RepeatedDetail const& rule, metrics::Picture const& picture, metrics::Picture& detail) {
    auto const light = quell::detail::light_around(detail.size, picture.pixels);
    for (std::size_t i = 0; i < detail.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            float const most = rule.most * static_cast<float>(light[i]);
            float& value = detail.pixels[i][c];
            value = is_finite(value) ? std::clamp(value, -most, most) : 0.f;
        }
}

std::vector<float> repeated_share(RepeatedDetail const& rule, metrics::Picture const& detail, metrics::Picture const& picture,
                                  ViewOf<Planar<>, Motion> motion, metrics::Picture const& before) {
    using quell::detail::product_of;
    std::vector<float> shares(detail.pixels.size(), 1.f);
    if (before.pixels.size() != detail.pixels.size()) return shares;
    auto const size = detail.size;
    auto const light = quell::detail::light_around(size, picture.pixels);
    auto const before_here = quell::detail::moved(before.pixels, motion);
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
