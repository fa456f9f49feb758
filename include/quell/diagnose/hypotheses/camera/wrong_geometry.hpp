#pragma once

#include <quell/diagnose/hypotheses/camera/geometry_contest.hpp>
#include <quell/diagnose/hypotheses/camera/still_camera.hpp>

#include <utility>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// What is known of the geometry after all mistakes were tried.
enum class GeometryIs {
    unknown, ///< no mistake explains what does not fit, or there is too little to go by
    right,   ///< depth, normals and cameras fit
    wrong,   ///< a finding says how
};

inline std::vector<GeometryMistake> mistakes_of_geometry(Observation const& seen, Geometry const& own) {
    auto all = mistakes_of_view(own);
    auto const add = [&](std::vector<GeometryMistake> more) {
        for (auto& one : more) all.push_back(std::move(one));
    };
    add(mistakes_of_axes(own)), add(mistakes_of_surfaces(own)), add(mistakes_of_linearity(own));
    if (auto const& before = seen.notes().camera_before; before && known(*before))
        add({{Mistake::guides_behind, "with the cameras of one frame earlier",
              "fill depth, normals, albedo and motion from the frame that the signal is of; or frame.camera is one frame ahead",
              Geometry{.now = seen.camera_then, .then = *before, .scattered = own.scattered}}});
    return all;
}

inline Finding finding_of(Observation const& seen, std::vector<std::pair<GeometryContest, GeometryMistake>> const& winners) {
    auto const& [contest, best] = winners.front();
    Finding finding{best.mistake, best.without + ", " + contest.counts(), best.remedy};
    for (std::size_t i = 1; i < winners.size(); ++i) {
        auto const& other = winners[i].second;
        if (other.mistake == best.mistake || GeometryContest(seen, other.geometry, best.geometry).second_wins()) continue;
        if (std::ranges::find(finding.or_else, other.mistake) != finding.or_else.end()) continue;
        finding.or_else.push_back(other.mistake);
        finding.remedy += "; or " + std::string(quell::name_of(other.mistake)) + ", which looks the same here: " + other.remedy;
    }
    return finding;
}

/// Guides of the frame before have its motion. Where motion follows the given cameras, those are not ahead.
inline bool motion_allows(Observation const& seen, Geometry const& own, GeometryMistake const& mistake) {
    if (mistake.mistake != Mistake::guides_behind || !seen.motion || !seen.has_then) return true;
    auto const share = [&](Geometry const& by) { return agreeing(motion_pairs(seen, by.now, by.then), {1.f, 1.f}).share(); };
    return share(mistake.geometry) > share(own) - 0.02;
}

/// The camera's mistakes first, by depth and normals alone: what the host says of motion must not decide them.
inline GeometryIs find_wrong_geometry(Observation const& seen, std::vector<Finding>& findings) {
    if (!seen.depth || !known(seen.camera)) return GeometryIs::unknown;
    bool const has_past = seen.has_then && seen.depth_then && known(seen.camera_then);
    if (!has_past && !seen.normal) return GeometryIs::unknown;
    Geometry const own{.now = seen.camera, .then = has_past ? seen.camera_then : seen.camera, .scattered = is_scattered(seen)};
    Misfit const misfit(seen, own, 1);
    if (misfit.is_small()) return has_past ? GeometryIs::right : GeometryIs::unknown;
    if (has_past && find_still_camera(seen, findings)) return GeometryIs::wrong;
    auto winners = winners_of(seen, own, mistakes_of_geometry(seen, own));
    // The search for a projection and a unit is long, and needless where all fits without.
    if (winners.empty() || !Misfit(seen, winners[0].second.geometry, 8).is_small()) {
        auto all = mistakes_of_geometry(seen, own);
        for (auto& one : mistakes_of_projection(seen, own)) all.push_back(std::move(one));
        if (has_past)
            for (auto& one : mistakes_of_unit(seen, own)) all.push_back(std::move(one));
        winners = winners_of(seen, own, std::move(all));
    }
    std::erase_if(winners, [&](auto const& winner) { return !motion_allows(seen, own, winner.second); });
    auto& in_a_row = seen.notes().misfits_in_a_row;
    in_a_row = winners.empty() ? 0 : in_a_row + 1;
    if (winners.empty()) return GeometryIs::unknown;
    if (in_a_row >= 2) findings.push_back(finding_of(seen, winners));
    return GeometryIs::wrong;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
