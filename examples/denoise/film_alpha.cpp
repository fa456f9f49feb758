#include <denoise/denoised_frame.hpp>
#include <denoise/film_alpha.hpp>

#include <quell/core/real.hpp>

#include <algorithm>
#include <cmath>

namespace quell::examples {

namespace {
/// The least or the greatest within `radius` pixels, by rows and then by columns. What is not finite counts as 0.
std::vector<float> extreme_within(std::vector<float> values, Extent size, int radius, auto const& better) {
    for (auto& value : values) value = is_finite(value) ? value : 0.f;
    auto const along = [&](int length, int lines, auto const& index) {
        auto const from = values;
        for (int line = 0; line < lines; ++line)
            for (int i = 0; i < length; ++i)
                for (int j = std::max(i - radius, 0); j <= std::min(i + radius, length - 1); ++j)
                    values[index(line, i)] = better(values[index(line, i)], from[index(line, j)]);
    };
    auto const width = static_cast<std::size_t>(size.width);
    along(size.width, size.height, [&](int y, int x) { return static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x); });
    along(size.height, size.width, [&](int x, int y) { return static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x); });
    return values;
}
} // namespace

void limit_alpha(std::vector<float>& denoised, std::vector<float> const& alpha, Extent size) {
    constexpr int radius = 3;
    auto const least = extreme_within(alpha, size, radius, [](float a, float b) { return std::min(a, b); });
    auto const most = extreme_within(alpha, size, radius, [](float a, float b) { return std::max(a, b); });
    for (std::size_t i = 0; i < denoised.size(); ++i) denoised[i] = std::clamp(denoised[i], least[i], most[i]);
}

bool FilmAlpha::is_empty_around(std::vector<float> const& alpha, int x, int y) const {
    for (int j = std::max(y - 1, 0); j <= std::min(y + 1, size.height - 1); ++j)
        for (int i = std::max(x - 1, 0); i <= std::min(x + 1, size.width - 1); ++i)
            if (alpha[static_cast<std::size_t>(j) * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(i)] != 0.f)
                return false;
    return true;
}

/// Those of the four pixels around a place that the history is interpolated from.
bool FilmAlpha::was_empty(glm::vec2 const& place) const {
    if (past.empty() || !is_finite(place.x) || !is_finite(place.y)) return true;
    float const left = std::floor(place.x - 0.5f), top = std::floor(place.y - 0.5f);
    float const right = place.x - 0.5f > left ? left + 1.f : left, bottom = place.y - 0.5f > top ? top + 1.f : top;
    for (float const y : {top, bottom})
        for (float const x : {left, right}) {
            bool const inside = x >= 0.f && y >= 0.f && x < static_cast<float>(size.width) && y < static_cast<float>(size.height);
            if (inside && past[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(x)] != 0.f)
                return false;
        }
    return true;
}

void FilmAlpha::clear_empty(DenoisedFrame& frame, std::vector<float> const& alpha, Frame<Channels<Motion>> const& motion) {
    if (!(size == frame.picture.size)) past.clear();
    size = frame.picture.size;
    auto const vectors = motion[quell::motion].view();
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            glm::vec2 const here{static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f};
            if (!is_empty_around(alpha, x, y) || !was_empty(here + glm::vec2(vectors.get(0, x, y), vectors.get(1, x, y)))) continue;
            auto const i = static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(x);
            frame.picture.pixels[i] = glm::vec3(0.f);
            for (auto& signal : frame.signals) signal.pixels[i] = glm::vec3(0.f);
            frame.alpha[i] = 0.f;
        }
    past = frame.alpha;
}

} // namespace quell::examples
