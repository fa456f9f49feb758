#pragma once

#include <quell/diagnose/hypotheses/motion_by_history.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Compares where motion leads with where the cameras say that a static surface was. A moving object is found by its motion only.
inline Comparison comparison_with_cameras(Observation const& seen) {
    StaticMotion const expected(seen.camera, seen.camera_then, seen.size);
    Trial by_motion, by_cameras;
    for_each_hit(seen, [&](int x, int y) {
        auto const found = vec2_at(seen.motion, x, y);
        auto const still = expected.at(x, y, seen.depth(0, x, y));
        if (!still || !all_finite(found) || !all_finite(*still)) return;
        by_motion.add(seen, x, y, found), by_cameras.add(seen, x, y, *still);
    });
    Comparison comparison;
    add(comparison, by_motion, by_cameras);
    return comparison;
}

/// No convention explains it: motion loses the past where the cameras find it, two frames in a row.
inline void find_disagreement(Observation const& seen, ComparedMotions const& pairs, std::vector<Finding>& findings) {
    if (!seen.depth_then) return;
    BestConvention const choice(pairs, seen);
    auto const comparison = comparison_with_cameras(seen);
    bool const disagrees = choice.own.share() < 0.5 && comparison.second >= 50 && comparison.second > 2 * comparison.first;
    auto& in_a_row = seen.notes().disagreed_in_a_row;
    in_a_row = disagrees ? in_a_row + 1 : 0;
    if (in_a_row < 2) return;
    findings.push_back({Mistake::motion_disagrees,
                        "of " + std::to_string(pairs.size()) + " surface pixels " + percent(choice.own.share()) +
                            " move as depth and cameras say of what stands still, and no known convention makes it more than " +
                            percent(choice.best.share()) + "; " + std::to_string(comparison.second) +
                            " find their surface in the last frame where the cameras say and not by motion, " +
                            std::to_string(comparison.first) + " the other way round",
                        "compare one pixel by hand: motion is where its point was in the last picture less where it is in this one, in "
                        "pixels, x first, y down, with the matrices of camera.view and camera.projection in both frames"});
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
