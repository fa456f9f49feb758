#pragma once

#include <quell/diagnose/hypotheses/compared_motion.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// The camera never changes, although all surfaces move. Returns whether that is so.
inline bool find_still_camera(Observation const& seen, std::vector<Finding>& findings) {
    if (!seen.has_then || !seen.motion || seen.camera.view != seen.camera_then.view) return false;
    if (seen.camera.projection != seen.camera_then.projection) return false;
    Tally moves;
    std::vector<float> lengths;
    for (auto const& pair : still_pairs(seen)) moves.add(glm::length(pair.found) > 0.05f), lengths.push_back(glm::length(pair.found));
    long long places = 0;
    for_each_place(seen.size, [&](int, int) { ++places; });
    if (moves.share() < 0.98 || 2 * moves.asked < places) return false;
    findings.push_back({Mistake::camera_never_moves,
                        "view and projection are those of the last frame, but " + percent(moves.share()) +
                            " of all surface pixels move, by " + number(static_cast<double>(median(lengths))) + " pixels (median)",
                        "set frame.camera in every frame; where it is right, motion of what stands still must be 0"});
    return true;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
