#pragma once

#include <quell/diagnose/hypotheses/camera/geometry_contest.hpp>
#include <quell/diagnose/hypotheses/motion/motion_hypotheses.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Units that depth may be in where the camera is in others: powers of ten, inches and feet.
inline constexpr std::array likely_units{1e-3f, 1e-2f, 1e-1f, 1e1f, 1e2f, 1e3f, 0.0254f, 1.f / 0.0254f, 0.3048f, 1.f / 0.3048f};

inline std::vector<GeometryMistake> mistakes_by_motion(Geometry const& own) {
    auto mistakes = mistakes_of_view(own);
    for (auto& one : mistakes_of_axes(own)) mistakes.push_back(std::move(one));
    for (float const unit : likely_units) mistakes.push_back(mistake_of_unit(own, unit));
    return mistakes;
}
/// Motion of what stands still, by a geometry that may have depth in another unit.
inline ComparedMotions moving_by(Observation seen, Geometry const& geometry) {
    seen.depth = [depth = seen.depth, unit = geometry.unit](int c, int x, int y) { return unit * depth(c, x, y); };
    return moving(motion_pairs(seen, geometry.now, geometry.then));
}

/// Mistakes of the camera that depth and normals leave open, by motion: without the mistake static surfaces would move as expected. It
/// must explain more than any motion convention does, too: a camera that only translates looks like motion of the wrong sign, the commoner
/// mistake. Where it explains as much, the few surfaces that tell something decide. Returns whether one is found.
/// @param fits whether depth and normals fit without any mistake
/// @param as_good gets the mistakes that explain as much as a convention of motion does, where nothing decides
inline bool find_geometry_by_motion(Observation const& seen, ComparedMotions const& pairs, bool fits, std::vector<Finding>& findings,
                                    std::vector<GeometryMistake>& as_good) {
    auto const own = agreeing(pairs, {1.f, 1.f});
    auto const by_convention = BestConvention(pairs, seen).best.share();
    double const least = own.share() + clear_margin;
    Geometry const geometry{.now = seen.camera, .then = seen.camera_then, .scattered = is_scattered(seen)};
    std::optional<GeometryMistake> best;
    Tally share{};
    for (auto& mistake : mistakes_by_motion(geometry)) {
        auto const others = moving_by(seen, mistake.geometry);
        auto const agree = agreeing(others, {1.f, 1.f});
        if (others.size() < fewest_pairs || agree.share() < least || (best && agree.share() < share.share() + 0.02)) continue;
        GeometryContest const contest(seen, geometry, mistake.geometry);
        bool const of_unit = mistake.mistake == Mistake::depth_unit, as_much = agree.share() >= by_convention - 0.02;
        bool const explains_more = !fits && !of_unit && agree.share() >= by_convention + 0.02 && !contest.second_loses();
        if (explains_more || (as_much && contest.is_favoured()))
            best = std::move(mistake), share = agree;
        else if (as_much && !of_unit && !contest.second_loses())
            as_good.push_back(std::move(mistake));
    }
    if (!best) return false;
    findings.push_back({best->mistake,
                        percent(own.share()) + " of the surface pixels move as depth and cameras say of what stands still, but " +
                            percent(share.share()) + " " + best->without,
                        best->remedy});
    return true;
}

/// Adds mistakes that explain as much as a finding does.
inline void add_alternatives(Finding& finding, std::vector<GeometryMistake> const& as_good) {
    for (auto const& other : as_good) {
        if (std::ranges::find(finding.or_else, other.mistake) != finding.or_else.end()) continue;
        finding.or_else.push_back(other.mistake);
        finding.remedy += "; or " + std::string(quell::name_of(other.mistake)) + ", which looks the same here: " + other.remedy;
    }
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
