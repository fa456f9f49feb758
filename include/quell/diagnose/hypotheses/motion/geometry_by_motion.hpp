#pragma once

#include <quell/diagnose/hypotheses/camera/geometry_contest.hpp>
#include <quell/diagnose/hypotheses/motion/motion_hypotheses.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Mistakes of the camera that depth and normals leave open, by motion: without the mistake static surfaces would move as expected. It
/// must explain more than any motion convention does, too: a camera that only translates looks like motion of the wrong sign, the commoner
/// mistake. Where it explains as much, the few surfaces that tell something decide. Returns whether one is found.
/// @param fits whether depth and normals fit without any mistake
inline bool find_geometry_by_motion(Observation const& seen, ComparedMotions const& pairs, bool fits, std::vector<Finding>& findings) {
    auto const own = agreeing(pairs, {1.f, 1.f});
    auto const by_convention = BestConvention(pairs, seen).best.share();
    double const least = own.share() + clear_margin;
    Geometry const geometry{.now = seen.camera, .then = seen.camera_then, .scattered = is_scattered(seen)};
    auto mistakes = mistakes_of_view(geometry);
    for (auto& one : mistakes_of_axes(geometry)) mistakes.push_back(std::move(one));
    GeometryMistake const* best = nullptr;
    Tally share{};
    for (auto const& mistake : mistakes) {
        auto const others = moving(motion_pairs(seen, mistake.geometry.now, mistake.geometry.then));
        auto const agree = agreeing(others, {1.f, 1.f});
        if (others.size() < fewest_pairs || agree.share() < least || (best && agree.share() < share.share() + 0.02)) continue;
        GeometryContest const contest(seen, geometry, mistake.geometry);
        bool const explains_more = !fits && agree.share() >= by_convention + 0.02 && !contest.second_loses();
        bool const is_favoured = agree.share() >= by_convention - 0.02 && contest.is_favoured();
        if (!explains_more && !is_favoured) continue;
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
