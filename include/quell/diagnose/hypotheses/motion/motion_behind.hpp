#pragma once

#include <quell/diagnose/hypotheses/motion/motion_hypotheses.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Pixels that show another surface than in the last frame, by whether their vector is the one of the surface that is there (yes) or was.
inline Tally of_present_surfaces(Observation const& seen, Camera const& now, Camera const& then) {
    StaticMotion const still(now, then, seen.size);
    // What is infinitely far away moves as what is very far away.
    auto const expected = [&](int x, int y, float depth) { return still.at(x, y, is_finite(depth) ? depth : 1e6f); };
    Tally present, fitting;
    for_each_hit(seen, [&](int x, int y) {
        float const z = seen.depth(0, x, y), before = seen.depth_then(0, x, y);
        auto const found = vec2_at(seen.motion, x, y);
        auto const here = expected(x, y, z), there = expected(x, y, before);
        if (!here || !there || !all_finite(found)) return;
        bool const fits_here = ComparedMotion{found, *here}.agrees(found), fits_there = ComparedMotion{found, *there}.agrees(found);
        fitting.add(fits_here);
        if (std::abs(before - z) < 0.1f * z) return;
        if (glm::length(*here - *there) > 0.5f) {
            if (fits_here != fits_there) present.add(fits_here);
        } else if (before < z)
            // Something that moved away has left its vectors.
            present.add(fits_here);
    });
    // Where little fits, motion is wrong in another way.
    return fitting.share() > 0.6 ? present : Tally{};
}

/// Vectors of the frame before, in three frames. Returns whether they are, or may be.
inline bool find_motion_behind(Observation const& seen, Camera const& now, Camera const& then, std::vector<Finding>& findings) {
    auto const present = of_present_surfaces(seen, now, then);
    auto& in_a_row = seen.notes().behind_in_a_row;
    bool const behind = present.asked - present.yes >= 10 && present.share() < 0.25;
    in_a_row = behind ? in_a_row + 1 : 0;
    if (in_a_row < 2) return behind;
    findings.push_back({Mistake::motion_behind,
                        "of " + std::to_string(present.asked) + " pixels that show another surface than in the last frame, " +
                            percent(1. - present.share()) + " have the motion of what was there in that one",
                        "fill motion, and frame.camera, from the frame that depth is of: look at double buffers and at matrices that are "
                        "set after they are used"});
    return true;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
