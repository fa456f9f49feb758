#pragma once

#include <quell/diagnose/motion_hypotheses.hpp>

namespace quell::detail {

/// Whether a vector leads from (x, y) to a place of the last frame with the same depth; of what is outside nobody knows.
inline bool leads_to_same_depth(Observation const& seen, int x, int y, glm::vec2 motion) {
    auto const column = std::floor(static_cast<float>(x) + 0.5f + motion.x), row = std::floor(static_cast<float>(y) + 0.5f + motion.y);
    auto const width = static_cast<float>(seen.size.width), height = static_cast<float>(seen.size.height);
    if (!(column >= 0.f && column < width && row >= 0.f && row < height)) return false;
    auto const z = seen.depth(0, x, y), then = seen.depth_then(0, static_cast<int>(column), static_cast<int>(row));
    return is_finite(then) && std::abs(then - z) < 0.03f * std::abs(z);
}

/// How often two conventions lead to different places, of which only one has the right depth: at the edges of what moves.
struct Duel {
    int own = 0, other = 0;

    Duel(Observation const& seen, glm::vec2 factor) {
        for_each_hit(seen, [&](int x, int y) {
            auto const found = vec2_at(seen.motion, x, y);
            if (!all_finite(found) || !all_finite(found * factor) || glm::length(found * factor - found) < 1.f) return;
            bool const a = leads_to_same_depth(seen, x, y, found), b = leads_to_same_depth(seen, x, y, found * factor);
            own += a && !b, other += b && !a;
        });
    }
    /// What was hidden a frame ago is found by neither, or by chance.
    [[nodiscard]] bool won() const { return other >= 30 && other > 4 * own; }
};

/// Sign, unit and direction of y, by what moves before a camera of which nothing is known, or which stands still.
inline void find_motion_convention_by_history(Observation const& seen, std::vector<Finding>& findings) {
    Duel best(seen, {1.f, 1.f});
    auto convention = seen.convention;
    for (auto const each : motion_conventions(seen.convention)) {
        Duel const duel(seen, correction(each, seen.convention, seen.size));
        if (duel.won() && 2 * (duel.other - duel.own) > 3 * (best.other - best.own)) best = duel, convention = each;
    }
    if (!best.won()) return;
    auto const factor = correction(convention, seen.convention, seen.size);
    report_convention(convention, seen,
                      std::to_string(best.own) +
                          " moving pixels find their depth in the last frame by motion as it is and not by motion times " +
                          pair(factor.x, factor.y) + ", " + std::to_string(best.other) + " the other way round",
                      findings);
}

} // namespace quell::detail
