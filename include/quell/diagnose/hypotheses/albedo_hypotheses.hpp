#pragma once

#include <quell/diagnose/observation.hpp>
#include <quell/diagnose/statistics.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

inline void find_albedo_range(Observation const& seen, std::vector<Finding>& findings) {
    Tally above, black;
    float maximum = 0.f;
    for_each_hit(seen, [&](int x, int y) {
        auto const a = vec3_at(seen.albedo, x, y);
        float const largest = std::max(a.x, std::max(a.y, a.z));
        above.add(largest > 1.005f), black.add(largest < 1e-3f), maximum = std::max(maximum, largest);
    });
    if (above.share() > 0.005)
        findings.push_back({Mistake::albedo_above_one,
                            percent(above.share()) + " of the surface pixels have more than 1 in a component; the most is " +
                                number(static_cast<double>(maximum)),
                            "write reflectance in [0, 1] as a linear colour, and 1 on emitters, whose light belongs into the signal"});
    // Metals have no diffuse albedo, but no picture shows only metal.
    if (black.share() > 0.98)
        findings.push_back({Mistake::albedo_black, percent(black.share()) + " of the surface pixels are black in albedo",
                            "fill the channel with the diffuse reflectance that the signal was multiplied by, or leave Demodulate{} out"});
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
