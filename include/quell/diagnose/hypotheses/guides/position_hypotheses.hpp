#pragma once

#include <quell/diagnose/observation.hpp>
#include <quell/diagnose/statistics.hpp>

#include <algorithm>
#include <string>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Surface pixels in which a position is exactly the world's origin: memory that nobody filled.
inline Tally zeros_of(Observation const& seen, Lookup const& image) {
    Tally zeros;
    for_each_hit(seen, [&](int x, int y) { zeros.add(vec3_at(image, x, y) == glm::vec3(0.f)); });
    return zeros;
}

/// Positions that are never filled, though the same thing's position in this frame is somewhere else.
inline void find_zero_positions(Observation const& seen, std::vector<Finding>& findings) {
    for (auto const& guide : seen.positions) {
        auto const zeros = zeros_of(seen, guide.image);
        if (guide.name == "light_previous") {
            auto const light = std::ranges::find(seen.positions, "light", &GuideSeen::name);
            if (light != seen.positions.end() && zeros_of(seen, light->image).share() > 0.5) continue;
        } else if (guide.name == "light") {
            continue; // it may be there
        }
        if (zeros.asked < 50 || zeros.share() < 0.95) continue;
        findings.push_back({Mistake::positions_zero,
                            "'" + guide.name + "' is (0, 0, 0) in " + percent(zeros.share()) + " of the surface pixels",
                            "fill it with positions in world space; what does not move has the same one in both frames"});
    }
}

/// What a ray hit, at the origin in many pixels: a host that has no value for nothing.
inline void find_zero_hits(Observation const& seen, std::vector<Finding>& findings) {
    for (auto const& guide : seen.hit_points) {
        auto const zeros = zeros_of(seen, guide.image);
        if (zeros.yes < 20 || zeros.share() < 0.01) continue;
        findings.push_back({Mistake::hits_zero, "'" + guide.name + "' is (0, 0, 0) in " + percent(zeros.share()) + " of the surface pixels",
                            "write NaN or infinity where the ray hit nothing: 0 is a place in the world"});
        return; // the previous position of the same has the same cause
    }
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
