#pragma once

#include <quell/diagnose/hypotheses/camera/geometry_contest.hpp>
#include <quell/diagnose/hypotheses/motion/motion_hypotheses.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Mistakes of the camera that depth and normals leave open, by motion: without the mistake static surfaces would move as expected. It
/// must explain more than any motion convention does, too: a camera that only translates looks like motion of the wrong sign, the commoner
/// mistake. Returns whether one is found.
inline bool find_geometry_by_motion(Observation const& seen, ComparedMotions const& pairs, std::vector<Finding>& findings) {
    auto const own = agreeing(pairs, {1.f, 1.f});
    double const least = std::max(own.share() + clear_margin, BestConvention(pairs, seen).best.share() + 0.02);
    Geometry const geometry{.now = seen.camera, .then = seen.camera_then, .scattered = is_scattered(seen)};
    auto mistakes = mistakes_of_view(geometry);
    for (auto& one : mistakes_of_axes(geometry)) mistakes.push_back(std::move(one));
    GeometryMistake const* best = nullptr;
    Tally share{};
    for (auto const& mistake : mistakes) {
        auto const others = moving(motion_pairs(seen, mistake.geometry.now, mistake.geometry.then));
        auto const agree = agreeing(others, {1.f, 1.f});
        if (others.size() < fewest_pairs || agree.share() < least || (best && agree.share() < share.share() + 0.02)) continue;
        if (GeometryContest(seen, geometry, mistake.geometry).second_loses()) continue;
        best = &mistake, share = agree;
    }
    if (!best) return false;
    findings.push_back({best->mistake,
                        percent(own.share()) + " of the surface pixels move as depth and cameras say of what stands still, but " +
                            percent(share.share()) + " " + best->without,
                        best->remedy});
    return true;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
