#include <denoise/linear_picture.hpp>
#include <denoise/unlit_film.hpp>

#include <quell/io/frame_image.hpp>

#include <algorithm>
#include <cmath>

namespace quell::examples {

namespace {

/// How far another pixel of the surface may be, in pixels.
constexpr int radius = 2;
/// Of depths of one surface, relative to the nearer one: more than floors have, that are not seen at a very flat angle.
constexpr float depth_difference = 0.1f;
/// Least cosine between normals of one surface.
constexpr float least_cosine = 0.9f;
/// One in so many of them may have light: at edges some show other things as well.
constexpr int most_lit = 4;

/// What tells surfaces apart.
class Surfaces {
    std::vector<float> depth, x, y, z; ///< empty: not known

    static std::vector<float> component(io::ExrImage const& image, io::Source const& source) {
        return image.has_all(source.sum) ? io::component_of(image, source) : std::vector<float>();
    }

public:
    Surfaces(io::ExrImage const& image, io::ChannelNames const& names)
        : depth(component(image, io::sources_of(names, quell::depth)[0])), x(component(image, io::sources_of(names, normal)[0])),
          y(component(image, io::sources_of(names, normal)[1])), z(component(image, io::sources_of(names, normal)[2])) {}

    /// Whether two pixels may show the same.
    [[nodiscard]] bool are_one(std::size_t a, std::size_t b) const {
        if (!depth.empty()) {
            auto const near = std::min(depth[a], depth[b]), far = std::max(depth[a], depth[b]);
            if (far - near > depth_difference * std::abs(near)) return false; // of two misses the difference is 0, or no number
        }
        if (x.empty() || y.empty() || z.empty()) return true;
        auto const dot = [&](std::size_t i, std::size_t j) { return x[i] * x[j] + y[i] * y[j] + z[i] * z[j]; };
        // Normals of catchers may be longer than 1; where there is no surface they are 0.
        return !(dot(a, b) < least_cosine * std::sqrt(dot(a, a) * dot(b, b)));
    }
};

} // namespace

std::vector<bool> unlit_film(std::vector<bool> const& has_light, io::ExrImage const& image, io::ChannelNames const& names) {
    Surfaces const surfaces(image, names);
    auto const [width, height] = image.size;
    std::vector<bool> unlit(has_light.size());
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            auto const here = index_of(image.size, x, y);
            if (has_light[here]) continue;
            int alike = 0, lit = 0;
            for (int j = std::max(y - radius, 0); j <= std::min(y + radius, height - 1); ++j)
                for (int i = std::max(x - radius, 0); i <= std::min(x + radius, width - 1); ++i)
                    if (auto const there = index_of(image.size, i, j); surfaces.are_one(here, there)) ++alike, lit += has_light[there];
            unlit[here] = most_lit * lit < alike;
        }
    return unlit;
}

} // namespace quell::examples
