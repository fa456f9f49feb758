#pragma once

#include <quell/diagnose/hypotheses/static_motion.hpp>
#include <quell/diagnose/observation.hpp>
#include <quell/diagnose/statistics.hpp>

#include <glm/geometric.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// A motion vector of the host, and the one of a static surface there.
struct ComparedMotion {
    glm::vec2 found, expected;
    /// Moving objects never agree, so shares are only compared with each other.
    [[nodiscard]] bool agrees(glm::vec2 motion) const { return glm::length(motion - expected) < 0.1f + 0.03f * glm::length(expected); }
    /// Without expected motion, all conventions agree.
    [[nodiscard]] bool moves() const { return glm::length(expected) > 0.5f; }
};
using ComparedMotions = std::vector<ComparedMotion>;

/// At pixels where depth and cameras give the expected motion.
inline ComparedMotions motion_pairs(Observation const& seen, Camera const& now, Camera const& then) {
    StaticMotion const expected(now, then, seen.size);
    ComparedMotions pairs;
    for_each_hit(seen, [&](int x, int y) {
        auto const found = vec2_at(seen.motion, x, y);
        auto const still = expected.at(x, y, seen.depth(0, x, y));
        if (still && all_finite(found) && all_finite(*still)) pairs.push_back({found, *still});
    });
    return pairs;
}
/// For a static camera.
inline ComparedMotions still_pairs(Observation const& seen) {
    ComparedMotions pairs;
    for_each_hit(seen, [&](int x, int y) {
        if (auto const found = vec2_at(seen.motion, x, y); all_finite(found)) pairs.push_back({found, glm::vec2(0.f)});
    });
    return pairs;
}
inline ComparedMotions moving(ComparedMotions pairs) {
    std::erase_if(pairs, [](ComparedMotion const& pair) { return !pair.moves(); });
    return pairs;
}
inline Tally agreeing(ComparedMotions const& pairs, glm::vec2 factor) {
    Tally tally;
    for (auto const& pair : pairs) tally.add(pair.agrees(pair.found * factor));
    return tally;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
