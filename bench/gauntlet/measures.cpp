#include <gauntlet/measures.hpp>

#include <algorithm>
#include <cmath>

namespace quell::gauntlet {

namespace {
constexpr int window_side = 25, window_step = 5;

double square_of(glm::vec3 a, glm::vec3 b) {
    double sum = 0;
    for (int c = 0; c < 3; ++c) sum += (static_cast<double>(a[c]) - b[c]) * (static_cast<double>(a[c]) - b[c]);
    return sum / 3;
}
} // namespace

double colour_error(metrics::Picture const& picture, metrics::Picture const& reference, metrics::Mask const& mask) {
    double sum = 0;
    long long count = 0;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        if (!mask.empty() && mask[i] == 0) continue;
        sum += square_of(picture.pixels[i], reference.pixels[i]), ++count;
    }
    return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : 0;
}

std::vector<double> window_errors(metrics::Picture const& picture, metrics::Picture const& reference) {
    auto const shown = metrics::displayed(picture), wanted = metrics::displayed(reference);
    auto const size = picture.size;
    int const width = std::min(window_side, size.width), height = std::min(window_side, size.height);
    std::vector<double> errors;
    for (int y = 0; y + height <= size.height; y += window_step)
        for (int x = 0; x + width <= size.width; x += window_step) {
            double sum = 0;
            for (int v = y; v < y + height; ++v)
                for (int u = x; u < x + width; ++u) {
                    auto const i = static_cast<std::size_t>(v * size.width + u);
                    sum += square_of(shown.pixels[i], wanted.pixels[i]);
                }
            errors.push_back(std::sqrt(sum / (width * height)));
        }
    return errors;
}

metrics::Mask away_from(metrics::Mask const& mask, Extent size, int distance) {
    metrics::Mask result(mask.size(), 1);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            if (mask[static_cast<std::size_t>(y * size.width + x)] == 0) continue;
            for (int v = std::max(0, y - distance); v <= std::min(size.height - 1, y + distance); ++v)
                for (int u = std::max(0, x - distance); u <= std::min(size.width - 1, x + distance); ++u)
                    result[static_cast<std::size_t>(v * size.width + u)] = 0;
        }
    return result;
}

} // namespace quell::gauntlet
