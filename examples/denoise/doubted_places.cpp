#include <denoise/doubted_places.hpp>

#include <quell/core/real.hpp>
#include <quell/core/value.hpp>

#include <algorithm>
#include <cmath>

namespace quell::examples {

namespace {

using Pixels = std::vector<glm::vec3>;

/// A place counts as so much of its own edge, where colours are 1: few pixels that were missed don't decide what stands for the others.
constexpr float own_edge = .5f;

/// All pixels of a surface that are reached from one over those for which may_join(pixel). They are taken into `is_taken`.
template <class F>
std::vector<std::size_t> flood(SurfaceLinks const& surfaces, std::size_t from, std::vector<bool>& is_taken, F&& may_join) {
    std::vector<std::size_t> pixels{from};
    is_taken[from] = true;
    for (std::size_t k = 0; k < pixels.size(); ++k)
        surfaces.for_each(pixels[k], 0, [&](std::size_t there) {
            if (!is_taken[there] && may_join(there)) is_taken[there] = true, pixels.push_back(there);
        });
    return pixels;
}

/// Of the colours around a place on its own surface, the geometric mean, with those of its own edge as 1.
glm::vec3 stands_for(SurfaceLinks const& surfaces, Pixels const& colours, std::vector<bool> const& mask,
                     std::vector<std::size_t> const& place) {
    glm::vec3 sum(0.f);
    float count = own_edge * std::sqrt(static_cast<float>(place.size()));
    for (auto const pixel : place)
        surfaces.for_each(pixel, 0, [&](std::size_t there) {
            auto const& colour = colours[there];
            if (mask[there] || !all_finite(colour) || !(std::min({colour.x, colour.y, colour.z}) > 0.f)) return;
            sum += glm::vec3(std::log(colour.x), std::log(colour.y), std::log(colour.z)), count += 1.f;
        });
    sum /= count;
    return {std::exp(sum.x), std::exp(sum.y), std::exp(sum.z)};
}

} // namespace

std::vector<bool> places(SurfaceLinks const& surfaces, std::size_t pixels, std::size_t fewest,
                         std::function<bool(std::size_t)> const& begins, std::function<bool(std::size_t)> const& goes_on) {
    std::vector<bool> is_taken(pixels, false), mask(pixels, false);
    for (std::size_t i = 0; i < pixels; ++i) {
        if (is_taken[i] || !begins(i)) continue;
        auto const place = flood(surfaces, i, is_taken, goes_on);
        for (auto const pixel : place) mask[pixel] = place.size() >= fewest;
    }
    return mask;
}

void close_gaps(SurfaceLinks const& surfaces, std::vector<bool>& mask) {
    std::vector<int> more;
    for (bool const is_masked : mask) more.push_back(is_masked ? 1 : -1);
    more = surfaces.window_sums(std::move(more));
    for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = mask[i] || more[i] > 0;
}

void flatten(SurfaceLinks const& surfaces, std::vector<bool> const& mask, Pixels& colours) {
    auto const given = colours;
    std::vector<bool> is_done(mask.size(), false);
    for (std::size_t i = 0; i < mask.size(); ++i) {
        if (!mask[i] || is_done[i]) continue;
        auto const place = flood(surfaces, i, is_done, [&](std::size_t there) { return mask[there]; });
        auto const constant = stands_for(surfaces, given, mask, place);
        for (auto const pixel : place) colours[pixel] = constant;
    }
}

} // namespace quell::examples
