#pragma once

#include <quell/diagnose/observation.hpp>
#include <quell/diagnose/statistics.hpp>

#include <glm/geometric.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

inline bool is_unit(glm::vec3 n) { return std::abs(glm::length(n) - 1.f) < 0.02f; }

/// Returns whether lengths are wrong; directions then need no test.
/// @param depth_is_wrong so that it does not tell the sky from surfaces: normals of 0 may then be the sky's
inline bool find_normal_length(Observation const& seen, bool depth_is_wrong, std::vector<Finding>& findings) {
    Tally unit, packed;
    std::vector<float> lengths;
    for_each_hit(seen, [&](int x, int y) {
        auto const n = vec3_at(seen.normal, x, y);
        if (depth_is_wrong && n == glm::vec3(0.f)) return;
        unit.add(is_unit(n)), packed.add(is_unit(n * 2.f - 1.f)), lengths.push_back(glm::length(n));
    });
    if (unit.asked == 0 || unit.share() > 0.8) return false;
    auto const evidence =
        percent(unit.share()) + " of the normals are of length 1; the median is " + number(static_cast<double>(median(lengths)));
    if (packed.share() > unit.share() + 0.25)
        findings.push_back({Mistake::normal_packed, evidence + ", but " + percent(packed.share()) + " are of length 1 as 2 n - 1",
                            "write 2 n - 1, which is in [-1, 1]"});
    else
        findings.push_back({Mistake::normal_not_unit, evidence, "normalise them, after interpolation too"});
    return true;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
