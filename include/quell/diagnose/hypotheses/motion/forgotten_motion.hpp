#pragma once

#include <quell/diagnose/hypotheses/motion/motion_hypotheses.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Whether all around a place the last frame saw farther than this depth.
inline bool saw_farther(Observation const& seen, glm::vec2 place, float depth) {
    glm::vec2 const last(seen.size.width - 2, seen.size.height - 2);
    if (!(place.x >= 1.f && place.y >= 1.f && place.x < last.x && place.y < last.y)) return false;
    int const column = static_cast<int>(place.x), row = static_cast<int>(place.y);
    for (int y = row - 1; y <= row + 2; ++y)
        for (int x = column - 1; x <= column + 2; ++x)
            if (auto const then = seen.depth_then(0, x, y); !(then > 1.05f * depth)) return false;
    return true;
}

/// Whether a surface is more than a wire, which may lie between the places that the last frame looked at: it fills a square of two pixels.
inline bool is_thick(Observation const& seen, int x, int y) {
    float const z = seen.depth(0, x, y);
    auto const is = [&](int i, int j) {
        bool const inside = i >= 0 && j >= 0 && i < seen.size.width && j < seen.size.height;
        return inside && std::abs(seen.depth(0, i, j) - z) < 0.05f * z;
    };
    for (int const i : {x - 1, x + 1})
        for (int const j : {y - 1, y + 1})
            if (is(i, y) && is(x, j) && is(i, j)) return true;
    return false;
}

/// Pixels whose motion is that of what stands still, but where the last frame looked through the surface: what stands still may have been
/// hidden, but it cannot have been absent. It shows before the edge with which a thing comes.
inline Tally absent_before(Observation const& seen, Camera const& now, Camera const& then) {
    StaticMotion const still(now, then, seen.size);
    auto const jitter = now.jitter - then.jitter;
    Tally absent;
    for_each_hit(seen, [&](int x, int y) {
        auto const found = vec2_at(seen.motion, x, y);
        auto const was = still.then(x, y, seen.depth(0, x, y));
        if (!was || !all_finite(found) || glm::length(found - was->motion) > 0.005f + 0.01f * glm::length(was->motion)) return;
        absent.add(saw_farther(seen, glm::vec2(x, y) + was->motion + jitter, was->depth) && is_thick(seen, x, y));
    });
    return absent;
}

/// An object without motion of its own, in three frames: in a single one it may just have appeared.
inline void find_forgotten_motion(Observation const& seen, Camera const& now, Camera const& then, std::vector<Finding>& findings) {
    auto const absent = absent_before(seen, now, then);
    auto& in_a_row = seen.notes().absent_in_a_row;
    auto& total = seen.notes().absent;
    bool const some = absent.yes >= 3 && absent.share() > 2e-4;
    in_a_row = some ? in_a_row + 1 : 0, total = some ? total + absent.yes : 0;
    if (in_a_row < 3 || total < 20) return;
    findings.push_back({Mistake::motion_forgotten,
                        "at " + std::to_string(absent.yes) + " of " + std::to_string(absent.asked) +
                            " pixels that move like what stands still, the last frame saw something farther away where they were",
                        "compute motion with the previous transform of every object too, and the previous shape of what bends: before the "
                        "edge of which thing that is, debug_images(debug_rejection, history) shows"});
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
