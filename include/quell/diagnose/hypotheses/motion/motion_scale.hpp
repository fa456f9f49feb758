#pragma once

#include <quell/diagnose/hypotheses/motion/motion_hypotheses.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Motion along the expected one, but longer or shorter by the same factor everywhere.
struct CommonFactor {
    glm::vec2 factor{1.f}; ///< found over expected
    Tally sharing;

    explicit CommonFactor(ComparedMotions const& pairs) {
        for (int axis : {0, 1}) {
            std::vector<float> factors;
            for (auto const& pair : pairs)
                if (std::abs(pair.expected[axis]) > 0.5f) factors.push_back(pair.found[axis] / pair.expected[axis]);
            if (factors.size() >= fewest_pairs) factor[axis] = median(factors);
        }
        for (auto const& pair : pairs)
            sharing.add(glm::length(pair.found - factor * pair.expected) < 0.05f + 0.02f * glm::length(pair.expected));
    }
};

/// Motion of half the length, of two frames, or in pixels of another resolution.
inline void find_motion_scale(ComparedMotions const& pairs, std::vector<Finding>& findings) {
    CommonFactor const common(pairs);
    auto const own = agreeing(pairs, {1.f, 1.f});
    auto const& f = common.factor;
    bool const differs = std::abs(f.x - 1.f) > 0.1f || std::abs(f.y - 1.f) > 0.1f, usable = std::abs(f.x) > 0.02f && std::abs(f.y) > 0.02f;
    if (!differs || !usable || common.sharing.share() < std::max(0.6, own.share() + clear_margin)) return;
    findings.push_back({Mistake::motion_scale,
                        "of " + std::to_string(pairs.size()) + " surface pixels " + percent(common.sharing.share()) + " move by " +
                            pair(static_cast<double>(f.x), static_cast<double>(f.y)) + " times what depth and cameras say, " +
                            percent(own.share()) + " by that itself",
                        "multiply motion by " + pair(1. / static_cast<double>(f.x), 1. / static_cast<double>(f.y)) +
                            ": it is in pixels of this picture, from this frame to the one before it"});
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
