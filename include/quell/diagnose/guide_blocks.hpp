#pragma once

#include <quell/diagnose/observation.hpp>
#include <quell/diagnose/statistics.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

// Parts of the picture that are found again in the next one by their guides: they tell how the picture moves without a camera. Each is
// large, so that neither fine textures nor samples beside the pixels' centres hide it.

inline Texel texel_at(Observation const& seen, int x, int y) {
    Texel texel;
    if (seen.depth) texel.depth = seen.depth(0, x, y);
    // Where there is no surface, normal and albedo may be anything.
    if (!is_finite(texel.depth)) return texel;
    if (seen.normal) texel.normal = vec3_at(seen.normal, x, y);
    if (seen.albedo) texel.albedo = vec3_at(seen.albedo, x, y);
    return texel;
}

/// 0 for equal ones, at most 3. A tenth of the depth, a right angle and half of the range of albedo count as different.
/// @param nearer by how much all around is nearer in the second: a factor
inline float difference(Texel const& a, Texel const& b, float nearer) {
    if (is_finite(a.depth) != is_finite(b.depth)) return 1.f;
    if (!is_finite(a.depth)) return 0.f;
    auto const part = [](float value) { return value < 1.f ? value : 1.f; };
    auto const colour = glm::abs(a.albedo - b.albedo);
    return part(10.f * std::abs(1.f - nearer * b.depth / a.depth)) + part(0.7f * glm::length(a.normal - b.normal)) +
           part(2.f * std::max(colour.x, std::max(colour.y, colour.z)));
}

/// Pixels from one texel of a block to the next.
inline int block_stride(Extent size) { return std::max(1, size.width / 80); }
/// The unit of the search.
inline int search_step(Extent size) { return std::max(1, size.width / 240); }

inline bool is_inside(Extent size, glm::ivec2 at) { return at.x >= 0 && at.y >= 0 && at.x < size.width && at.y < size.height; }

/// The pixel of a texel.
inline glm::ivec2 pixel_of(GuideBlock const& block, std::size_t i, Extent size) {
    constexpr int side = 2 * GuideBlock::half + 1;
    int const index = static_cast<int>(i);
    return block.at + (glm::ivec2(index % side, index / side) - GuideBlock::half) * block_stride(size);
}

/// A grid of them.
inline std::vector<GuideBlock> blocks_of(Observation const& seen) {
    constexpr int columns = 6, rows = 4;
    std::vector<GuideBlock> blocks;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            GuideBlock block{{(2 * column + 1) * seen.size.width / (2 * columns), (2 * row + 1) * seen.size.height / (2 * rows)}};
            auto const last = GuideBlock::count - 1;
            if (!is_inside(seen.size, pixel_of(block, 0, seen.size)) || !is_inside(seen.size, pixel_of(block, last, seen.size))) continue;
            for (std::size_t i = 0; i < GuideBlock::count; ++i) {
                auto const at = pixel_of(block, i, seen.size);
                block.texels[i] = texel_at(seen, at.x, at.y);
            }
            blocks.push_back(block);
        }
    return blocks;
}

/// A block of an earlier frame in this one.
class BlockSearch {
    Observation const& seen;
    GuideBlock const& block;
    std::vector<float> rests;
    glm::vec2 nearest{}; ///< of the places that were tried for the whole block

public:
    float least = 9.f; ///< its difference at the best place so far, per texel
    float typical;     ///< the median of places all around

    BlockSearch(Observation const& seen_, GuideBlock const& block_) : seen(seen_), block(block_) {
        for (int const reach : {5, 10})
            for (int y = -1; y <= 1; ++y)
                for (int x = -1; x <= 1; ++x)
                    if (x != 0 || y != 0) moved_by(glm::ivec2(x, y) * reach * search_step(seen.size));
        typical = median(rests);
    }
    /// Difference per texel where each went so far; empty where most left the picture.
    std::optional<float> moved(auto&& way_of) {
        std::vector<std::pair<Texel const*, Texel>> pairs;
        std::vector<float> factors;
        for (std::size_t i = 0; i < GuideBlock::count; ++i) {
            auto const way = way_of(i);
            if (!all_finite(way)) continue;
            auto const at = pixel_of(block, i, seen.size) + glm::ivec2(glm::round(way));
            if (!is_inside(seen.size, at)) continue;
            pairs.emplace_back(&block.texels[i], texel_at(seen, at.x, at.y));
            float const factor = pairs.back().first->depth / pairs.back().second.depth;
            if (is_finite(factor) && factor > 0.f) factors.push_back(factor);
        }
        if (2 * pairs.size() < GuideBlock::count) return std::nullopt;
        // A camera that comes closer makes all depths less.
        float const nearer = factors.empty() ? 1.f : median(factors);
        float sum = 0.f;
        for (auto const& [then, now] : pairs) sum += difference(*then, now, nearer);
        sum /= static_cast<float>(pairs.size());
        rests.push_back(sum), least = std::min(least, sum);
        return sum;
    }
    void moved_by(glm::vec2 way) {
        float const before = least;
        moved([=](std::size_t) { return way; });
        if (least < before) nearest = way;
    }
    /// Tries places all around those that the texels went to. Returns the best, as a way from there.
    glm::vec2 around(auto&& way_of, int reach, float step) {
        glm::vec2 best{};
        for (int y = -reach; y <= reach; ++y)
            for (int x = -reach; x <= reach; ++x) {
                auto const more = glm::vec2(x, y) * step * static_cast<float>(search_step(seen.size));
                float const before = least;
                moved([&](std::size_t i) { return way_of(i) + more; });
                if (least < before) best = more;
            }
        return best;
    }
    /// Tries places as far as most things move in some frames.
    void everywhere() {
        constexpr int reach = 6;
        auto const step = static_cast<float>(search_step(seen.size));
        for (int y = -reach; y <= reach; ++y)
            for (int x = -reach; x <= reach; ++x) moved_by(2.f * step * glm::vec2(x, y));
        for (auto const centre = nearest; auto const way : {glm::vec2(1, 0), glm::vec2(-1, 0), glm::vec2(0, 1), glm::vec2(0, -1)})
            moved_by(centre + step * way);
    }
    /// What counts as a difference between places.
    [[nodiscard]] float margin() const { return 0.25f * (typical - least); }
    /// Whether the block may be there, for all that was tried.
    [[nodiscard]] bool may_be(std::optional<float> rest) const { return rest && *rest <= least + margin(); }
    /// Whether places differ enough to tell.
    [[nodiscard]] bool tells() const { return typical - least > 0.03f && least < 0.75f * typical; }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
