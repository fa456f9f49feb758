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
inline glm::ivec2 pixel_of(GuideBlock const& block, int column, int row, Extent size) {
    return block.at + (glm::ivec2(column, row) - GuideBlock::side / 2) * block_stride(size);
}

/// A grid of them.
inline std::vector<GuideBlock> blocks_of(Observation const& seen) {
    constexpr int columns = 6, rows = 4;
    std::vector<GuideBlock> blocks;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            GuideBlock block{{(2 * column + 1) * seen.size.width / (2 * columns), (2 * row + 1) * seen.size.height / (2 * rows)}};
            constexpr int last = GuideBlock::side - 1;
            if (!is_inside(seen.size, pixel_of(block, 0, 0, seen.size)) || !is_inside(seen.size, pixel_of(block, last, last, seen.size)))
                continue;
            for (int y = 0; y <= last; ++y)
                for (int x = 0; x <= last; ++x) {
                    auto const at = pixel_of(block, x, y, seen.size);
                    block.texels[static_cast<std::size_t>(y * GuideBlock::side + x)] = texel_at(seen, at.x, at.y);
                }
            blocks.push_back(block);
        }
    return blocks;
}

/// A block of an earlier frame in this one.
class BlockSearch {
    Observation const& seen;
    GuideBlock const& block;
    glm::vec2 jitter_change;
    std::vector<float> rests;
    float typical = 0.f; ///< the median of places all around

public:
    float least = 9.f; ///< the difference at the best place so far, per texel

    BlockSearch(Observation const& seen_, GuideBlock const& block_, BlockNotes const& notes)
        : seen(seen_), block(block_), jitter_change(seen_.camera.jitter - notes.jitter) {}

    /// Difference per texel where its thirds went, and so much more; empty where most left the picture.
    std::optional<float> at(GuideBlock::Ways const& ways, glm::vec2 more = {}) {
        std::vector<std::pair<Texel const*, Texel>> pairs;
        std::vector<float> factors;
        for (int y = 0; y < GuideBlock::side; ++y)
            for (int x = 0; x < GuideBlock::side; ++x) {
                auto const way = ways[static_cast<std::size_t>(y / GuideBlock::third * 3 + x / GuideBlock::third)] + more - jitter_change;
                if (!all_finite(way)) continue;
                auto const p = pixel_of(block, x, y, seen.size) + glm::ivec2(glm::round(way));
                if (!is_inside(seen.size, p)) continue;
                pairs.emplace_back(&block.texels[static_cast<std::size_t>(y * GuideBlock::side + x)], texel_at(seen, p.x, p.y));
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
    /// Tries places so far away that they say what is typical.
    void far_around(GuideBlock::Ways const& ways, float reach) {
        for (auto const way : {glm::vec2(1, 0), glm::vec2(-1, 0), glm::vec2(0, 1), glm::vec2(0, -1)}) at(ways, reach * step() * way);
        typical = median(rests);
    }
    /// Tries a square of places. Returns the best, as a way from the middle.
    glm::vec2 around(GuideBlock::Ways const& ways, int reach, float every) {
        glm::vec2 best{};
        for (int y = -reach; y <= reach; ++y)
            for (int x = -reach; x <= reach; ++x) {
                float const before = least;
                at(ways, glm::vec2(x, y) * every * step());
                if (least < before) best = glm::vec2(x, y) * every * step();
            }
        return best;
    }
    [[nodiscard]] float step() const { return static_cast<float>(search_step(seen.size)); }
    /// How much of what is typical is left at the best place.
    [[nodiscard]] float share_left() const { return typical > 0.f ? least / typical : 0.f; }
    /// What is left where nothing is known.
    [[nodiscard]] float rest_of(std::optional<float> rest) const { return rest.value_or(typical); }
    /// What counts as a difference between places.
    [[nodiscard]] float margin() const { return 0.25f * (typical - least); }
    /// Whether the block may be there, for all that was tried.
    [[nodiscard]] bool may_be(std::optional<float> rest) const { return rest && *rest <= least + margin(); }
    /// Whether places differ at all.
    [[nodiscard]] bool is_varied() const { return typical > 0.05f; }
    /// Whether they differ enough to tell.
    [[nodiscard]] bool tells() const { return typical - least > 0.03f && least < 0.75f * typical; }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
