#pragma once

#include <quell/diagnose/observation.hpp>
#include <quell/diagnose/statistics.hpp>

#include <glm/geometric.hpp>

namespace quell::detail {

inline bool is_unit(glm::vec3 n) { return std::abs(glm::length(n) - 1.f) < 0.02f; }

/// Pixels without a normal at the largest depth: the sky of a host with a far plane.
inline Tally far_without_normal(Observation const& seen) {
    auto const has_none = [&](int x, int y) { return vec3_at(seen.normal, x, y) == glm::vec3(0.f); };
    float farthest = 0.f;
    for_each_hit(seen, [&](int x, int y) {
        if (seen.depth) farthest = std::max(farthest, seen.depth(0, x, y));
    });
    Tally distant;
    for_each_hit(seen, [&](int x, int y) {
        if (seen.depth && has_none(x, y)) distant.add(seen.depth(0, x, y) > 0.999f * farthest);
    });
    return distant;
}

/// Returns whether lengths are wrong; directions then need no test.
inline bool find_normal_length(Observation const& seen, std::vector<Finding>& findings) {
    Tally unit, packed;
    std::vector<float> lengths;
    for_each_hit(seen, [&](int x, int y) {
        auto const n = vec3_at(seen.normal, x, y);
        unit.add(is_unit(n)), packed.add(is_unit(n * 2.f - 1.f)), lengths.push_back(glm::length(n));
    });
    if (unit.asked == 0 || unit.share() > 0.8) return false;
    auto const evidence =
        percent(unit.share()) + " of the normals are of length 1; the median is " + number(static_cast<double>(median(lengths)));
    auto const distant = far_without_normal(seen);
    if (distant.share() > 0.98 && static_cast<double>(distant.yes) > 0.98 * static_cast<double>(unit.asked - unit.yes) && unit.yes > 0)
        findings.push_back({Mistake::depth_of_misses,
                            evidence + ", and " + std::to_string(distant.yes) +
                                " of those that were looked at are 0 and have the farthest depth of the picture",
                            "write +infinity into depth where there is no surface"});
    else if (packed.share() > unit.share() + 0.25)
        findings.push_back({Mistake::normal_packed, evidence + ", but " + percent(packed.share()) + " are of length 1 as 2 n - 1",
                            "write 2 n - 1, which is in [-1, 1]"});
    else
        findings.push_back({Mistake::normal_not_unit, evidence, "normalise them, after interpolation too"});
    return true;
}

} // namespace quell::detail
