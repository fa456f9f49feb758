#include <denoise/guide_noise.hpp>

#include <quell/core/real.hpp>
#include <quell/core/value.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>

namespace quell::examples {

namespace {

constexpr int window = 5;            ///< pixels: what is larger mixes surfaces
constexpr int windows_wanted = 8192; ///< more of them say nothing more
/// A part's noise counts so often: the light that filters go by is noisier than the window says.
constexpr float noise_of_filters = 4.f;

/// A window of a picture, whose values are multiplied by `factor`, and what lies around it as far as variograms reach.
class Window {
    static constexpr int margin = 2;
    static constexpr int columns = window + 2 * margin, rows = window + margin; ///< none above
    std::array<glm::vec3, static_cast<std::size_t>(columns* rows)> values;      ///< not a number beside the picture

    [[nodiscard]] glm::vec3 const& at(int x, int y) const { return values[static_cast<std::size_t>(y * columns + x + margin)]; }
    template <class F> void for_each_pixel(F&& f) const {
        for (int y = 0; y < window; ++y)
            for (int x = 0; x < window; ++x) f(x, y, at(x, y));
    }
    /// Half the mean square of differences over (dx, dy).
    [[nodiscard]] float variogram(int dx, int dy) const {
        float sum = 0, count = 0;
        for_each_pixel([&](int x, int y, glm::vec3 const& here) {
            auto const off = at(x + dx, y + dy) - here;
            float const square = luminance(off * off);
            bool const is_told = is_finite(square);
            sum += is_told ? 0.5f * square : 0.f, count += is_told ? 1.f : 0.f;
        });
        return count > 0.f ? sum / count : 0.f;
    }

public:
    Window(LinearView const& of, int x0, int y0, glm::vec3 const& factor = glm::vec3(1.f)) {
        values.fill(glm::vec3(std::numeric_limits<float>::quiet_NaN()));
        int const first = std::max(x0 - margin, 0), last = std::min(x0 + window + margin, of.size.width);
        for (int y = y0; y < std::min(y0 + rows, of.size.height); ++y)
            for (int x = first; x < last; ++x)
                values[static_cast<std::size_t>((y - y0) * columns + x - x0 + margin)] = of[index_of(of.size, x, y)] * factor;
    }

    [[nodiscard]] glm::vec3 mean() const {
        glm::vec3 sum(0.f);
        float count = 0;
        for_each_pixel([&](int, int, glm::vec3 const& p) {
            if (all_finite(p)) sum += p, ++count;
        });
        return count > 0.f ? sum / count : sum;
    }
    [[nodiscard]] float variance() const {
        auto const around = mean();
        float sum = 0, count = 0;
        for_each_pixel([&](int, int, glm::vec3 const& p) {
            if (all_finite(p)) sum += luminance((p - around) * (p - around)), ++count;
        });
        return count > 0.f ? sum / count : 0.f;
    }
    [[nodiscard]] float noise() const {
        float least = std::numeric_limits<float>::max();
        for (auto const& [dx, dy] : {std::pair{1, 0}, {0, 1}, {1, 1}, {-1, 1}}) {
            float const near = variogram(dx, dy), far = variogram(2 * dx, 2 * dy);
            least = std::min(least, std::clamp(2.f * near - far, 0.f, near));
        }
        return least;
    }
};

/// Whether depths of a window scatter: the mean square of second differences of inverse depth, in the direction in which it is least, over
/// that of inverse depth. Floats round it to 1e-14; spheres of 50 pixels have 1e-7.
bool is_scattered(std::vector<float> const& depth, Extent size, int x0, int y0) {
    constexpr float smooth = 3e-7f;
    auto const inverse = [&](int x, int y) {
        float const z = depth[index_of(size, x, y)];
        return is_finite(z) && z > 0.f && z < 1e9f ? 1.f / z : 0.f;
    };
    float least = std::numeric_limits<float>::max(), all = 0, pixels = 0;
    for (auto const& [dx, dy] : {std::pair{1, 0}, {0, 1}, {1, 1}, {-1, 1}}) {
        float sum = 0, count = 0;
        for (int y = std::max(y0, dy); y < std::min(y0 + window, size.height - dy); ++y)
            for (int x = std::max(x0, 1); x < std::min(x0 + window, size.width - 1); ++x) {
                float const off = inverse(x, y) - 0.5f * (inverse(x - dx, y - dy) + inverse(x + dx, y + dy));
                sum += off * off, ++count;
            }
        if (count > 0.f) least = std::min(least, sum / count);
    }
    for (int y = y0; y < std::min(y0 + window, size.height); ++y)
        for (int x = x0; x < std::min(x0 + window, size.width); ++x) all += inverse(x, y) * inverse(x, y), ++pixels;
    return least > smooth * all / pixels;
}

/// Calls f(x, y) with the corners of windows all over the picture.
template <class F> void for_each_window(Extent size, F&& f) {
    int step = window;
    while ((size.width / step) * (size.height / step) > 2 * windows_wanted) ++step;
    for (int y = 0; y < size.height; y += step)
        for (int x = 0; x < size.width; x += step) f(x, y);
}

/// The mean light by which a colour becomes the part.
glm::vec3 light_of(glm::vec3 const& part, glm::vec3 const& colour) {
    constexpr float darkest = 1e-4f;
    return {part.x / std::max(colour.x, darkest), part.y / std::max(colour.y, darkest), part.z / std::max(colour.z, darkest)};
}

} // namespace

GuideErrors guide_errors(LinearView const& guide, GuideKind kind, LinearView const& part, LinearView const& whole,
                         std::vector<float> const& depth) {
    float usual = 0, count = 0;
    for_each_window(whole.size, [&](int x, int y) { usual += std::max(luminance(Window(whole, x, y).mean()), 0.f), ++count; });
    usual /= count;
    GuideErrors errors;
    for_each_window(whole.size, [&](int x, int y) {
        Window const of_part(part, x, y);
        auto const times = kind == GuideKind::factor ? light_of(of_part.mean(), Window(guide, x, y).mean()) : glm::vec3(1.f);
        Window const lit(guide, x, y, times);
        float const own = lit.noise(), structure = std::max(lit.variance() - own, 0.f), n = of_part.noise() * noise_of_filters;
        // About as the square of a display's curve.
        float const bright = std::max(luminance(Window(whole, x, y).mean()), 0.f);
        float const visible = 1.f / ((bright + 0.1f * usual + std::numeric_limits<float>::min()) * count);
        if (depth.empty() || is_scattered(depth, whole.size, x, y)) errors.noise += own * visible;
        if (structure + n > 0.f) errors.loss += structure * n / (structure + n) * visible;
    });
    return errors;
}

} // namespace quell::examples
