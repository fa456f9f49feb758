#include "sample_picture.hpp"

#include <support/png.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace quell::examples::sample {

namespace {

double hash(std::uint32_t x) {
    x = (x ^ x >> 16) * 0x7feb352dU;
    x = (x ^ x >> 15) * 0x846ca68bU;
    return static_cast<double>(x ^ x >> 16) / 4294967296.0;
}

Color ball_color(double x, double y, double radius, double angle) {
    double const z = std::sqrt(std::max(0.0, radius * radius - x * x - y * y));
    double const facing = (x * std::cos(angle) - y * 0.6 + z * 0.8) / radius;
    double const light = 0.12 + 0.75 * std::max(0.0, facing) + 0.6 * std::pow(std::max(0.0, facing), 60);
    return {std::min(1.0, light), std::min(1.0, light * 0.55), std::min(1.0, light * 0.32)};
}

Color floor_color(double x, double y, double angle) {
    double const depth = 0.35 / (y - 0.05);
    bool const dark = (static_cast<int>(std::floor(x * depth * 3 + 100)) + static_cast<int>(std::floor(depth * 4))) % 2 != 0;
    double const shadow = std::exp(-8 * ((x + 0.4 * std::cos(angle)) * (x + 0.4 * std::cos(angle)) + 6 * (y - 0.4) * (y - 0.4)));
    double const light = (dark ? 0.28 : 0.72) * (1 - 0.7 * shadow);
    return {light, light, light * 1.05};
}

Color scene_color(double x, double y, double angle) {
    constexpr double radius = 0.3;
    if (x * x + y * y < radius * radius) return ball_color(x, y, radius, angle);
    if (y > 0.1) return floor_color(x, y, angle);
    return {0.35 + 0.3 * y, 0.5 + 0.3 * y, 0.7 + 0.3 * y};
}

double difference(Color const& a, Color const& b) { return (std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2])) / 3; }

Color color_between(std::vector<unsigned> const& stops, double at) {
    double const place = std::clamp(at, 0.0, 1.0) * static_cast<double>(stops.size() - 1);
    std::size_t const low = std::min(static_cast<std::size_t>(place), stops.size() - 2);
    double const share = place - static_cast<double>(low);
    Color color{};
    for (unsigned i = 0; i < 3; ++i) {
        unsigned const shift = 16 - 8 * i;
        color[i] = ((stops[low] >> shift & 255) * (1 - share) + (stops[low + 1] >> shift & 255) * share) / 255;
    }
    return color;
}

} // namespace

Picture draw_scene(int width, int height, int frame) {
    Picture picture{width, height};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            picture.pixels.push_back(scene_color((x + 0.5 - width / 2.0) / height, (y + 0.5) / height - 0.5, 0.2 * frame));
    return picture;
}

Picture add_noise(Picture picture, double strength, int frame) {
    auto seed = static_cast<std::uint32_t>(frame) * 9781u + 17u;
    for (Color& color : picture.pixels)
        for (double& part : color) part = std::clamp(part + strength * (2 * hash(seed++) - 1), 0.0, 1.0);
    return picture;
}

Picture draw_difference(Picture const& a, Picture const& b, std::vector<unsigned> const& stops) {
    Picture map{a.width, a.height};
    for (std::size_t i = 0; i < a.pixels.size(); ++i) map.pixels.push_back(color_between(stops, difference(a.pixels[i], b.pixels[i])));
    return map;
}

double mean_difference(Picture const& a, Picture const& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) sum += difference(a.pixels[i], b.pixels[i]);
    return sum / static_cast<double>(a.pixels.size());
}

std::vector<unsigned char> encode_png(Picture const& picture) {
    metrics::Picture shown{{picture.width, picture.height}, {}};
    for (Color const& color : picture.pixels) shown.pixels.push_back(glm::vec3(color[0], color[1], color[2]));
    return examples::encode_png(shown);
}

} // namespace quell::examples::sample
