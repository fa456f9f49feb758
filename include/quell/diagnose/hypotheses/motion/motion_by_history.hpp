#pragma once

#include <quell/diagnose/hypotheses/motion/motion_hypotheses.hpp>

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

/// The vectors of this frame, in each reading.
inline std::vector<Trial> trials_of(Observation const& seen, std::vector<Reading> const& all) {
    std::vector<Trial> trials(all.size());
    for_each_hit(seen, [&](int x, int y) {
        auto const found = vec2_at(seen.motion, x, y);
        if (!all_finite(found) || found == glm::vec2(0.f)) return;
        for (std::size_t i = 0; i < trials.size(); ++i)
            trials[i].add(seen, x, y, found * all[i].scale * correction(all[i].convention, seen.convention, seen.size));
    });
    return trials;
}

/// Sign, unit and direction of y, by moving objects, where the camera is unknown or static.
inline void find_motion_convention_by_history(Observation const& seen, std::vector<Finding>& findings) {
    ReadingContest contest(seen.convention, seen.notes().comparisons);
    auto const trials = trials_of(seen, contest.entrants());
    contest.for_each_pair([&](Comparison& comparison, std::size_t a, std::size_t b) { add(comparison, trials[a], trials[b]); });
    auto const best = contest.best();
    // Shorter vectors lead to the same surface more often: that is no evidence.
    if (!contest.is_winner(best) || contest.is_scaled(best)) return;
    auto const convention = contest.reading(best).convention;
    auto const factor = correction(convention, seen.convention, seen.size);
    auto const counts = contest.comparison(0, best);
    report_convention(convention, seen,
                      std::to_string(counts.first) +
                          " moving pixels find their surface in the last frame by motion as it is and not by motion times " +
                          pair(static_cast<double>(factor.x), static_cast<double>(factor.y)) + ", " + std::to_string(counts.second) +
                          " the other way round, in all frames so far",
                      findings);
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
