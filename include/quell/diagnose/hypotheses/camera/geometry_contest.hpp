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

/// Counts a pixel for the one that fits clearly better. What both fit within rounding or noise tells nothing.
inline void judge(Comparison& comparison, std::optional<Residual> one, std::optional<Residual> other, float rounding) {
    if (!one || !other) return;
    ++comparison.apart;
    auto const beats = [=](Residual const& a, Residual const& b) { return a.value < 0.5f * b.value && b.value > rounding + 2.f * b.noise; };
    comparison.first += beats(*one, *other), comparison.second += beats(*other, *one);
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
    /// Whether most pixels are for it, and not only more than are for the first.
    [[nodiscard]] bool by_most() const { return 2 * depth.second > depth.apart || 2 * normal.second > normal.apart; }
    [[nodiscard]] std::string counts() const {
        auto const text = [](Comparison const& c) { return std::to_string(c.second) + " of " + std::to_string(c.apart); };
        return "depth fits the last frame's better at " + text(depth) + " pixels, and normals the slope of depth at " + text(normal);
    }

private:
    static bool clearly(Comparison const& c) {
        bool const often = 5 * c.second > c.apart && c.second > 5 * c.first, always = 20 * c.second > c.apart && c.second > 50 * c.first;
        return c.second >= 40 && (often || always);
    }
    static bool against(Comparison const& c) { return c.first >= 40 && c.first > c.second; }
};

/// How badly a geometry fits by one of the tests, and how badly it may where all is well.
struct TestMisfit {
    float middle = 0.f, quarter = 0.f; ///< the median, and what a quarter of the pixels exceeds
    float noise = 0.f;                 ///< median of what is allowed

    TestMisfit(std::vector<float>& values, std::vector<float>& noises) : middle(median(values)), noise(median(noises)) {
        // median() leaves the greater half behind it.
        std::vector<float> upper(values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
        quarter = median(upper);
    }
    /// Without noise all that stands still fits, not only what looks the same from everywhere.
    [[nodiscard]] bool is_within(float tolerance) const { return noise > 0.f ? middle < tolerance + noise : quarter < tolerance; }
};

/// How badly it fits by both.
struct Misfit {
    TestMisfit depth, normal;

    Misfit(Observation const& seen, Geometry const& geometry, int every) : Misfit(Values(seen, geometry, every)) {}
    [[nodiscard]] bool is_small() const { return depth.is_within(1e-4f) && normal.is_within(5e-3f); }
    /// To compare geometries by: a pixel's worth of normals counts about as much as one of depth.
    [[nodiscard]] float sum() const { return depth.middle + 0.1f * normal.middle; }

private:
    struct Values {
        std::array<std::vector<float>, 4> all;

        Values(Observation const& seen, Geometry const& geometry, int every) {
            GeometryTest const test(seen, geometry);
            for_each_some(seen, every, [&](int x, int y) {
                if (auto const d = test.of_depth(x, y)) all[0].push_back(d->value), all[1].push_back(d->noise);
                if (auto const n = test.of_normal(x, y)) all[2].push_back(n->value), all[3].push_back(n->noise);
            });
        }
    };
    explicit Misfit(Values values) : depth(values.all[0], values.all[1]), normal(values.all[2], values.all[3]) {}
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
    for (auto const axes : {glm::vec2(1, 1), glm::vec2(1, 0), glm::vec2(0, 1)}) {
        auto const factors = [=](float f) { return glm::vec2(axes.x > 0.f ? f : 1.f, axes.y > 0.f ? f : 1.f); };
        auto const make = [&](float f) { return changed(own, [&](Camera& c) { scale_projection(c, factors(f)); }); };
        float const roughly = best_factor(seen, make, 0.4f, 2.5f, 40);
        float const factor = best_factor(seen, make, roughly / 1.05f, roughly * 1.05f, 20);
        if (std::abs(std::log(factor)) > 0.03f) all.push_back(mistake_of_projection(own, factors(factor)));
    }
    return all;
}

/// The unit of depth with which all fits best.
inline std::vector<GeometryMistake> mistakes_of_unit(Observation const& seen, Geometry const& own) {
    auto const make = [&](float unit) { return mistake_of_unit(own, unit).geometry; };
    float const roughly = best_factor(seen, make, 1e-4f, 1e4f, 64);
    float const unit = best_factor(seen, make, roughly / 1.4f, roughly * 1.4f, 30);
    if (std::abs(std::log(unit)) < 0.1f) return {};
    return {mistake_of_unit(own, unit)};
}

/// Whether a mistake is to be believed: what is without it fits clearly better, and most of all.
inline bool is_likely(Observation const& seen, Geometry const& own, GeometryMistake const& mistake, GeometryContest const& contest) {
    if (contest.second_loses()) return false;
    Misfit const without(seen, mistake.geometry, 2);
    // A projection has room to fit to anything a little. Surfaces that tell nothing may be many.
    if (contest.second_wins() && (contest.by_most() || without.is_small())) return true;
    // Where noise hides the difference in each pixel, all together show it.
    return own.scattered && without.is_small() && without.sum() < 0.6f * Misfit(seen, own, 2).sum();
}

/// All mistakes with which depth and normals fit clearly better than without, best first.
inline std::vector<std::pair<GeometryContest, GeometryMistake>> winners_of(Observation const& seen, Geometry const& own,
                                                                           std::vector<GeometryMistake> mistakes) {
    std::vector<std::pair<GeometryContest, GeometryMistake>> winners;
    for (auto& mistake : mistakes) {
        GeometryContest const contest(seen, own, mistake.geometry);
        if (is_likely(seen, own, mistake, contest)) winners.emplace_back(contest, std::move(mistake));
    }
    auto const is_better = [&](Geometry const& one, Geometry const& other) {
        return GeometryContest(seen, other, one).second_wins() ||
               (own.scattered && Misfit(seen, one, 2).sum() < 0.6f * Misfit(seen, other, 2).sum());
    };
    for (std::size_t i = 1; i < winners.size(); ++i)
        if (is_better(winners[i].second.geometry, winners[0].second.geometry)) std::swap(winners[0], winners[i]);
    return winners;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
