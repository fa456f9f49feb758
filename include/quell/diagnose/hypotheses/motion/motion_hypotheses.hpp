#pragma once

#include <quell/diagnose/hypotheses/compared_motion.hpp>
#include <quell/diagnose/hypotheses/motion/readings.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

inline constexpr std::size_t fewest_pairs = 50; ///< evidence needs this many
inline constexpr double clear_margin = 0.25;    ///< a mistake's share must exceed the share of correct vectors by this

/// The convention that most vectors agree with; among similar shares, the one nearest to the pipeline's.
struct BestConvention {
    MotionConvention convention;
    Tally own, best;

    BestConvention(ComparedMotions const& pairs, Observation const& seen)
        : convention(seen.convention), own(agreeing(pairs, {1.f, 1.f})), best(own) {
        for (auto const each : motion_conventions(seen.convention)) {
            auto const tally = agreeing(pairs, correction(each, seen.convention, seen.size));
            if (tally.share() > best.share() + 0.02) best = tally, convention = each;
        }
    }
    [[nodiscard]] bool clear() const { return best.share() > own.share() + clear_margin; }
};

/// Sign, unit and direction of y, by a moving camera.
inline void find_motion_convention(Observation const& seen, ComparedMotions const& pairs, std::vector<Finding>& findings) {
    BestConvention const choice(pairs, seen);
    if (!choice.clear()) return;
    auto const factor = correction(choice.convention, seen.convention, seen.size);
    report_convention(choice.convention, seen,
                      "of " + std::to_string(pairs.size()) + " surface pixels " + percent(choice.own.share()) +
                          " move as depth and cameras say of what stands still, but " + percent(choice.best.share()) + " times " +
                          pair(factor.x, factor.y),
                      findings);
}

/// No motion on the screen although the camera moves.
inline void find_zero_motion(ComparedMotions const& pairs, std::vector<Finding>& findings) {
    Tally zero;
    std::vector<float> expected;
    for (auto const& pair : pairs) zero.add(glm::length(pair.found) < 1e-6f), expected.push_back(glm::length(pair.expected));
    // Objects that move with the camera have no motion; but then others move as expected.
    if (zero.share() < 0.6 || agreeing(pairs, {1.f, 1.f}).share() > 0.05) return;
    findings.push_back({Mistake::motion_zero,
                        "motion is exactly 0 in " + percent(zero.share()) + " of " + std::to_string(pairs.size()) +
                            " surface pixels, which by depth and cameras move by " + number(static_cast<double>(median(expected))) +
                            " pixels (median)",
                        "compute motion with the previous frame's matrices, which must not be those of this frame, and fill the channel"});
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
