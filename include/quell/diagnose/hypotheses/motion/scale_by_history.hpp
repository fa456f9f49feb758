#pragma once

#include <quell/diagnose/hypotheses/motion/motion_hypotheses.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// What motion is tried with.
inline constexpr std::array scales_of_motion{1.f, 0.5f, 2.f};

/// Whether the last frame saw something farther away at the four pixels around a place: the surface of that depth was not there.
inline bool saw_through(Observation const& seen, glm::vec2 place, float depth) {
    glm::vec2 const last(seen.size.width - 1, seen.size.height - 1);
    if (!(place.x >= 0.f && place.y >= 0.f && place.x < last.x && place.y < last.y)) return false;
    int const column = static_cast<int>(place.x), row = static_cast<int>(place.y);
    for (int y = row; y <= row + 1; ++y)
        for (int x = column; x <= column + 1; ++x)
            if (auto const then = seen.depth_then(0, x, y); !(then > 1.05f * depth)) return false;
    return true;
}

/// Motion of half or of twice the length, by things that move before others that are farther away: too short a vector leads out of the
/// thing at the edge with which it comes, too long a one at the edge with which it goes. What moves may have been hidden, so that it is no
/// evidence where a vector leads to what is nearer; but it cannot have been absent. For a camera that is known and hardly moves.
inline void find_scale_by_history(Observation const& seen, std::vector<Finding>& findings) {
    auto& absences = seen.notes().absences;
    auto const jitter = seen.camera.jitter - seen.camera_then.jitter;
    for_each_hit(seen, [&](int x, int y) {
        auto const found = vec2_at(seen.motion, x, y);
        if (!all_finite(found) || glm::length(found) < 0.5f) return;
        auto const z = seen.depth(0, x, y);
        for (std::size_t i = 0; i < absences.size(); ++i)
            absences[i] += saw_through(seen, glm::vec2(x, y) + found * scales_of_motion[i] + jitter, z) ? 1 : 0;
        ++seen.notes().moving;
    });
    auto const own = absences[0];
    if (own < 40 || own * 500 < seen.notes().moving) return;
    for (std::size_t i : {std::size_t{1}, std::size_t{2}}) {
        if (absences[i] * 10 > own || absences[3 - i] * 2 < own) continue;
        report_scale(scales_of_motion[i],
                     "at " + std::to_string(own) + " of " + std::to_string(seen.notes().moving) +
                         " pixels that move, the last frame saw something farther away where motion leads, and at " +
                         std::to_string(absences[i]) + " where " + number(static_cast<double>(scales_of_motion[i])) +
                         " times motion leads, in all frames so far",
                     findings);
        return;
    }
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
