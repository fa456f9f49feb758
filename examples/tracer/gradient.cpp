#include "gradient.hpp"

#include <glm/common.hpp>

#include <algorithm>

namespace quell::tracer {

bool has_gradient(glm::ivec2 pixel, Extent size, int frame, std::uint32_t seed) {
    constexpr int side = 3;
    auto const stratum = pixel / side, first = stratum * side;
    auto const extent = glm::min(glm::ivec2{side}, glm::ivec2{size.width, size.height} - first);
    auto const place = detail::combine(static_cast<std::uint32_t>(stratum.x), static_cast<std::uint32_t>(stratum.y));
    auto const random = detail::combine(detail::combine(place, static_cast<std::uint32_t>(frame)), seed);
    auto const chosen = static_cast<int>(random % static_cast<std::uint32_t>(extent.x * extent.y));
    return pixel == first + glm::ivec2{chosen % extent.x, chosen / extent.x};
}

glm::vec2 gradient_of(float now, float before) { return {now - before, std::max(now, before)}; }

} // namespace quell::tracer
