#pragma once

#include <quell/diagnose/hypotheses/motion_hypotheses.hpp>

#include <cmath>
#include <optional>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Relative difference between a pixel's depth and the depth that a vector leads to; empty where unknown.
using Mismatch = std::optional<float>;

/// Surfaces enter the picture from outside, but not from far.
inline Mismatch mismatch_outside(Extent size, glm::vec2 place) {
    glm::vec2 const whole(size.width, size.height);
    auto const beyond = glm::abs(place - glm::clamp(place, glm::vec2(0.f), whole)) / whole;
    return std::max(beyond.x, beyond.y) < 0.1f ? Mismatch() : 1.f;
}

/// The least of the four pixels of the last frame around the place.
inline Mismatch mismatch(Observation const& seen, int x, int y, glm::vec2 motion) {
    auto const place = glm::vec2(x, y) + motion;
    glm::vec2 const last(seen.size.width - 1, seen.size.height - 1);
    if (!(place.x >= 0.f && place.y >= 0.f && place.x < last.x && place.y < last.y)) return mismatch_outside(seen.size, place);
    int const column = static_cast<int>(place.x), row = static_cast<int>(place.y);
    auto const z = seen.depth(0, x, y);
    float minimum = 1.f;
    for (int j = row; j <= row + 1; ++j)
        for (int i = column; i <= column + 1; ++i) {
            auto const then = seen.depth_then(0, i, j);
            if (!is_finite(then)) continue;
            minimum = std::min(minimum, std::abs(then - z) / std::abs(z));
        }
    return minimum;
}

/// Where the vectors of a frame lead under one convention.
struct Trial {
    std::vector<glm::vec2> motions;
    std::vector<Mismatch> found;

    void add(Observation const& seen, int x, int y, glm::vec2 motion) {
        motions.push_back(motion), found.push_back(mismatch(seen, x, y, motion));
    }
};

/// Margins: a surface that approaches changes its depth a little, an edge by more.
inline bool finds(float one, float other) { return one < 0.06f && other > one + 0.04f; }

inline void add(Comparison& comparison, Trial const& a, Trial const& b) {
    for (std::size_t i = 0; i < a.motions.size(); ++i) {
        if (glm::length(a.motions[i] - b.motions[i]) < 1.f) continue;
        ++comparison.apart;
        if (!a.found[i] || !b.found[i]) continue;
        comparison.first += finds(*a.found[i], *b.found[i]), comparison.second += finds(*b.found[i], *a.found[i]);
    }
}

/// Compares all conventions pairwise on the vectors of all frames so far. The pipeline's is the first.
class Tournament {
    std::vector<MotionConvention> conventions;
    std::vector<Comparison>& comparisons;
    std::size_t best = 0;

public:
    explicit Tournament(Observation const& seen) : conventions(motion_conventions(seen.convention)), comparisons(seen.notes().comparisons) {
        comparisons.resize(conventions.size() * conventions.size());
        auto const trials = trials_of(seen);
        for (std::size_t a = 0; a < trials.size(); ++a)
            for (std::size_t b = 0; b < a; ++b) add(comparisons[a * trials.size() + b], trials[a], trials[b]);
        for (std::size_t i = 1; i < trials.size(); ++i)
            if (won(i, best)) best = i;
    }
    [[nodiscard]] MotionConvention convention() const { return conventions[best]; }
    /// The pipeline's convention against the best.
    [[nodiscard]] Comparison comparison() const { return comparison(0, best); }
    /// Whether the best beats the pipeline's convention, and all others that differ from that in as little.
    [[nodiscard]] bool decided() const {
        for (std::size_t i = 1; i < conventions.size(); ++i)
            if (i != best && mistakes_in(i) <= mistakes_in(best) && comparison(best, i).apart >= 20 && !won(best, i)) return false;
        return best > 0 && won(best, 0) && comparison().second >= 20;
    }

private:
    [[nodiscard]] std::size_t mistakes_in(std::size_t i) const { return mistakes_of(conventions[i], conventions[0]).size(); }
    [[nodiscard]] Comparison comparison(std::size_t a, std::size_t b) const {
        if (a > b) return comparisons[a * conventions.size() + b];
        auto const turned = comparisons[b * conventions.size() + a];
        return {turned.second, turned.first, turned.apart};
    }
    /// With a margin: disoccluded pixels match neither, or one by chance.
    [[nodiscard]] bool won(std::size_t a, std::size_t b) const {
        return comparison(a, b).first >= 8 && comparison(a, b).first > 4 * comparison(a, b).second;
    }

    [[nodiscard]] std::vector<Trial> trials_of(Observation const& seen) const {
        std::vector<Trial> trials(conventions.size());
        for_each_hit(seen, [&](int x, int y) {
            auto const found = vec2_at(seen.motion, x, y);
            if (!all_finite(found) || found == glm::vec2(0.f)) return;
            for (std::size_t i = 0; i < trials.size(); ++i)
                trials[i].add(seen, x, y, found * correction(conventions[i], seen.convention, seen.size));
        });
        return trials;
    }
};

/// Sign, unit and direction of y, by moving objects, where the camera is unknown or static.
inline void find_motion_convention_by_history(Observation const& seen, std::vector<Finding>& findings) {
    Tournament const tournament(seen);
    if (!tournament.decided()) return;
    auto const factor = correction(tournament.convention(), seen.convention, seen.size);
    report_convention(tournament.convention(), seen,
                      std::to_string(tournament.comparison().first) +
                          " moving pixels find their surface in the last frame by motion as it is and not by motion times " +
                          pair(factor.x, factor.y) + ", " + std::to_string(tournament.comparison().second) +
                          " the other way round, in all frames so far",
                      findings);
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
