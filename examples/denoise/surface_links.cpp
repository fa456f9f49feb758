#include <denoise/linear_picture.hpp>
#include <denoise/surface_links.hpp>

#include <quell/core/real.hpp>
#include <quell/core/value.hpp>
#include <quell/io/frame_image.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace quell::examples {

namespace {

constexpr float least_cosine = .8f; ///< of the angle between normals: a sphere of a radius of 15 pixels turns by so much over nine
/// Part of the depth by which it may be off that of the same plane, or of the same depth, one pixel away; n pixels away times the root of
/// n.
constexpr float farthest_off = .02f;

float inverse(float depth) { return is_finite(depth) && depth > 0.f ? 1.f / depth : 0.f; }

} // namespace

void SurfaceGuides::find_slopes(Extent size) {
    if (depth.empty()) return;
    auto const along = [&](int x, int y, int dx, int dy) {
        auto const at = [&](int i, int j) { return inverse(depth[index_of(size, i, j)]); };
        bool const has_before = x >= dx && y >= dy, has_after = x + dx < size.width && y + dy < size.height;
        float const before = has_before ? at(x, y) - at(x - dx, y - dy) : 0.f, after = has_after ? at(x + dx, y + dy) - at(x, y) : 0.f;
        if (!has_before || !has_after) return before + after;
        return std::abs(before) < std::abs(after) ? before : after;
    };
    for (auto& slope : slopes) slope.clear();
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) slopes[0].push_back(along(x, y, 1, 0)), slopes[1].push_back(along(x, y, 0, 1));
}

bool SurfaceGuides::are_on_one_plane(std::size_t pixel, std::size_t other, int dx, int dy) const {
    if (depth.empty()) return true;
    if (!is_finite(depth[pixel]) || !is_finite(depth[other])) return false;
    float const a = inverse(depth[pixel]), b = inverse(depth[other]);
    float const tolerated = farthest_off * std::sqrt(static_cast<float>(std::max(std::abs(dx), std::abs(dy)))) * std::min(a, b);
    if (std::abs(b - a) <= tolerated) return true;
    auto const are_on_plane_of = [&](std::size_t i) {
        return std::abs(b - a - slopes[0][i] * static_cast<float>(dx) - slopes[1][i] * static_cast<float>(dy)) <= tolerated;
    };
    return !slopes[0].empty() && (are_on_plane_of(pixel) || are_on_plane_of(other));
}

bool SurfaceGuides::are_one(std::size_t pixel, std::size_t other, int dx, int dy) const {
    if (!are_on_one_plane(pixel, other, dx, dy)) return false;
    if (normals[0].empty()) return true;
    float cosine = 0.f;
    for (auto const& component : normals) cosine += component[pixel] * component[other];
    return cosine >= least_cosine;
}

std::optional<SurfaceGuides> surface_guides_in(io::ExrImage const& image, io::ChannelNames const& names) {
    auto const of_depth = io::sources_of(names, depth), of_normal = io::sources_of(names, normal);
    auto const is_there = [&](auto const& sources) {
        auto const planes = io::planes_of(sources);
        return !planes.empty() && image.has_all(planes);
    };
    if (!is_there(of_depth) && !is_there(of_normal)) return std::nullopt;
    SurfaceGuides guides;
    if (is_there(of_depth)) {
        guides.depth = io::component_of(image, of_depth[0]);
        io::detail::mark_misses(guides.depth, image, of_depth[0], names);
        for (auto& each : guides.depth)
            if (!(each > 0.f)) each = std::numeric_limits<float>::infinity();
        guides.find_slopes(image.size);
    }
    if (is_there(of_normal))
        for (std::size_t c = 0; c < 3; ++c) guides.normals[c] = io::component_of(image, of_normal[c]);
    return guides;
}

SurfaceLinks::SurfaceLinks(Extent s, SurfaceGuides const& guides) : size(s), links(static_cast<std::size_t>(s.pixels())) {
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            for (std::size_t level = 0; level < lengths.size(); ++level)
                for (std::size_t d = 0; d < 4; ++d) {
                    int const length = lengths[level];
                    int const there_x = x + directions[d][0] * length, there_y = y + directions[d][1] * length;
                    if (there_x < 0 || there_x >= size.width || there_y >= size.height) continue;
                    auto const here = index_of(size, x, y), there = index_of(size, there_x, there_y);
                    if (!guides.are_one(here, there, there_x - x, there_y - y)) continue;
                    links[here] |= 1u << (8 * level + d);
                    links[there] |= 1u << (8 * level + d + 4);
                }
}

} // namespace quell::examples
