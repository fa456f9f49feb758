#pragma once

#include <quell/diagnose/hypotheses/camera/camera_mistakes.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Every `every`-th place with a surface.
void for_each_some(Observation const& seen, int every, auto&& f) {
    int count = 0;
    for_each_hit(seen, [&](int x, int y) {
        if (count++ % every == 0) f(x, y);
    });
}

/// Counts a pixel for the one that fits clearly better. What both fit within rounding tells nothing.
inline void judge(Comparison& comparison, std::optional<float> one, std::optional<float> other, float rounding) {
    if (!one || !other) return;
    ++comparison.apart;
    comparison.first += *one<0.5f * *other&& * other> rounding;
    comparison.second += *other<0.5f * *one&& * one> rounding;
}

/// Two geometries, pixel by pixel.
struct GeometryContest {
    Comparison depth, normal;

    GeometryContest(Observation const& seen, Geometry const& first, Geometry const& second, int every = 1) {
        GeometryTest const one(seen, first), other(seen, second);
        for_each_some(seen, every, [&](int x, int y) {
            judge(depth, one.of_depth(x, y), other.of_depth(x, y), 2e-5f);
            judge(normal, one.of_normal(x, y), other.of_normal(x, y), 2e-3f);
        });
    }
    /// Whether depth or normals are clearly for the second, and neither is clearly against it.
    [[nodiscard]] bool second_wins() const { return (clearly(depth) || clearly(normal)) && !second_loses(); }
    /// Whether depth or normals are against it.
    [[nodiscard]] bool second_loses() const { return against(depth) || against(normal); }
    /// Whether most pixels are for it.
    [[nodiscard]] bool by_most() const { return 2 * depth.second > depth.apart || 2 * normal.second > normal.apart; }
    [[nodiscard]] std::string counts() const {
        auto const text = [](Comparison const& c) { return std::to_string(c.second) + " of " + std::to_string(c.apart); };
        return "depth fits the last frame's better at " + text(depth) + " pixels, and normals the slope of depth at " + text(normal);
    }

private:
    static bool clearly(Comparison const& c) { return c.second >= 40 && 5 * c.second > c.apart && c.second > 5 * c.first; }
    static bool against(Comparison const& c) { return c.first >= 40 && c.first > c.second; }
};

/// How badly a geometry fits: medians of both tests.
struct Misfit {
    float depth = 0.f, normal = 0.f;

    Misfit(Observation const& seen, Geometry const& geometry, int every) {
        GeometryTest const test(seen, geometry);
        std::vector<float> depths, normals;
        for_each_some(seen, every, [&](int x, int y) {
            if (auto const d = test.of_depth(x, y)) depths.push_back(*d);
            if (auto const n = test.of_normal(x, y)) normals.push_back(*n);
        });
        depth = median(depths), normal = median(normals);
    }
    [[nodiscard]] bool is_small() const { return depth < 1e-4f && normal < 5e-3f; }
    /// To compare geometries by: a pixel's worth of normals counts about as much as one of depth.
    [[nodiscard]] float sum() const { return depth + 0.1f * normal; }
};

/// The best factor among some, by how well it fits.
template <class Make> float best_factor(Observation const& seen, Make&& geometry_of, float low, float high, int steps) {
    float best = 1.f, least = std::numeric_limits<float>::max();
    for (int i = 0; i <= steps; ++i) {
        float const factor = low * std::pow(high / low, static_cast<float>(i) / static_cast<float>(steps));
        float const misfit = Misfit(seen, geometry_of(factor), 8).sum();
        if (misfit < least) least = misfit, best = factor;
    }
    return best;
}
/// The field of view or the aspect ratio with which all fits best.
inline std::vector<GeometryMistake> mistakes_of_projection(Observation const& seen, Geometry const& own) {
    std::vector<GeometryMistake> all;
    for (bool const both : {true, false}) {
        auto const factors = [=](float f) { return glm::vec2(f, both ? f : 1.f); };
        auto const make = [&](float f) { return changed(own, [&](Camera& c) { scale_projection(c, factors(f)); }); };
        float const roughly = best_factor(seen, make, 0.4f, 2.5f, 40);
        float const factor = best_factor(seen, make, roughly / 1.05f, roughly * 1.05f, 20);
        if (std::abs(std::log(factor)) > 0.03f) all.push_back(mistake_of_projection(own, factors(factor)));
    }
    return all;
}

/// All mistakes with which depth and normals fit clearly better than without, best first.
inline std::vector<std::pair<GeometryContest, GeometryMistake>> winners_of(Observation const& seen, Geometry const& own,
                                                                           std::vector<GeometryMistake> mistakes) {
    std::vector<std::pair<GeometryContest, GeometryMistake>> winners;
    for (auto& mistake : mistakes) {
        GeometryContest const contest(seen, own, mistake.geometry);
        // A projection has room to fit to anything a little.
        bool const enough = mistake.mistake != Mistake::field_of_view || contest.by_most();
        if (contest.second_wins() && enough) winners.emplace_back(contest, std::move(mistake));
    }
    for (std::size_t i = 1; i < winners.size(); ++i)
        if (GeometryContest(seen, winners[0].second.geometry, winners[i].second.geometry).second_wins()) std::swap(winners[0], winners[i]);
    return winners;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
