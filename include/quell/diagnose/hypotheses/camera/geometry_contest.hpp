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
    /// Whether depth or normals are for it wherever they tell anything, though that may be a small part of the picture.
    [[nodiscard]] bool is_favoured() const { return (favours(depth) || favours(normal)) && !second_loses(); }
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
    static bool favours(Comparison const& c) { return c.second >= 40 && c.second > 10 * c.first; }
    static bool against(Comparison const& c) { return c.first >= 40 && c.first > c.second; }
};

/// How badly a geometry fits by one of the tests.
class TestMisfit {
    float tolerance, most_counted;
    std::vector<float> values{}, shares{}; ///< and of what is allowed
    bool is_noisy = false;

public:
    float middle = 0.f;     ///< the median
    float mean = 0.f;       ///< of what is not taken for an edge or for something that moves
    std::size_t pixels = 0; ///< that tell something
    bool is_small = true;

    TestMisfit(float rounding, float limit) : tolerance(rounding), most_counted(limit) {}
    void add(std::optional<Residual> residual) {
        if (!residual) return;
        values.push_back(residual->value), shares.push_back(residual->value / (tolerance + residual->noise));
        is_noisy = is_noisy || residual->noise > 0.f;
        mean += std::min(residual->value, most_counted);
    }
    /// Without noise all that stands still fits, and not only what looks the same from everywhere.
    void finish() {
        auto const quarter = static_cast<std::ptrdiff_t>(shares.size() / 4);
        middle = median(values), pixels = values.size();
        if (shares.empty()) return;
        mean /= static_cast<float>(shares.size());
        auto const most = is_noisy ? shares.begin() + 2 * quarter : shares.begin() + 3 * quarter;
        std::nth_element(shares.begin(), most, shares.end());
        is_small = *most < 1.f;
    }
};

/// How badly it fits by both.
struct Misfit {
    TestMisfit depth{1e-4f, 0.02f}, normal{5e-3f, 0.3f};

    Misfit(Observation const& seen, Geometry const& geometry, int every) {
        GeometryTest const test(seen, geometry);
        for_each_some(seen, every, [&](int x, int y) { depth.add(test.of_depth(x, y)), normal.add(test.of_normal(x, y)); });
        depth.finish(), normal.finish();
    }
    [[nodiscard]] bool is_small() const { return depth.is_small && normal.is_small; }
    /// To find the best of many by: a pixel's worth of normals counts about as much as one of depth. A floor alone often fits to any.
    [[nodiscard]] float sum() const { return depth.mean + 0.1f * normal.mean; }
    /// Whether it is far better than another by one of the tests, no worse by the other, and by as many pixels.
    [[nodiscard]] bool beats(Misfit const& other) const {
        bool const by_as_many = 4 * depth.pixels >= 3 * other.depth.pixels && 4 * normal.pixels >= 3 * other.normal.pixels;
        auto const is = [](TestMisfit const& a, TestMisfit const& b, float part) { return a.middle <= part * b.middle; };
        // Of few pixels, noise makes one better than another.
        constexpr std::size_t fewest = 100;
        bool const better =
            (depth.pixels >= fewest && is(depth, other.depth, 0.75f)) || (normal.pixels >= fewest && is(normal, other.normal, 0.75f));
        return by_as_many && better && is(depth, other.depth, 1.05f) && is(normal, other.normal, 1.05f);
    }
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
    return own.scattered && without.is_small() && without.beats(Misfit(seen, own, 2));
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
        return GeometryContest(seen, other, one).second_wins() || (own.scattered && Misfit(seen, one, 2).beats(Misfit(seen, other, 2)));
    };
    for (std::size_t i = 1; i < winners.size(); ++i)
        if (is_better(winners[i].second.geometry, winners[0].second.geometry)) std::swap(winners[0], winners[i]);
    return winners;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
