#include <denoise/surface_links.hpp>

#include <quell/core/real.hpp>

#include <algorithm>
#include <cmath>

namespace quell::examples {

namespace {

constexpr float least_cosine = .8f; ///< of the angle between normals: a sphere of a radius of 15 pixels turns by so much over nine
constexpr float steepest = .02f;    ///< part of the depth by which it changes over one pixel; over n pixels times the root of n

} // namespace

bool SurfaceGuides::are_one(std::size_t pixel, std::size_t other, int length) const {
    if (!depth.empty()) {
        float const a = depth[pixel], b = depth[other];
        if (!is_finite(a) || !is_finite(b)) return false;
        if (std::abs(a - b) > steepest * std::sqrt(static_cast<float>(length)) * std::min(a, b)) return false;
    }
    if (normals[0].empty()) return true;
    float cosine = 0.f;
    for (auto const& component : normals) cosine += component[pixel] * component[other];
    return cosine >= least_cosine;
}

SurfaceLinks::SurfaceLinks(Extent s, SurfaceGuides const& guides) : size(s), links(static_cast<std::size_t>(s.pixels())) {
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            for (std::size_t level = 0; level < lengths.size(); ++level)
                for (std::size_t d = 0; d < 4; ++d) {
                    int const length = lengths[level];
                    int const there_x = x + directions[d][0] * length, there_y = y + directions[d][1] * length;
                    if (there_x < 0 || there_x >= size.width || there_y >= size.height) continue;
                    auto const here = index(x, y), there = index(there_x, there_y);
                    if (!guides.are_one(here, there, length)) continue;
                    links[here] |= 1u << (8 * level + d);
                    links[there] |= 1u << (8 * level + d + 4);
                }
}

} // namespace quell::examples
