#pragma once

#include <quell/diagnose/hypotheses/motion/motion_conventions.hpp>
#include <quell/diagnose/notes.hpp>
#include <quell/diagnose/observation.hpp>
#include <quell/diagnose/statistics.hpp>

#include <string>
#include <vector>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// A way to read the vectors: of another convention, or longer or shorter than they should be.
struct Reading {
    MotionConvention convention;
    float scale = 1.f; ///< what they are multiplied by
};
inline std::vector<Reading> readings(MotionConvention taken_for) {
    std::vector<Reading> all;
    for (auto const each : motion_conventions(taken_for)) all.push_back({each});
    all.push_back({taken_for, 0.5f}), all.push_back({taken_for, 2.f});
    return all;
}
/// Compares readings pairwise, in all frames so far. The pipeline's own is the first.
class ReadingContest {
    std::vector<Reading> all;
    std::vector<Comparison>& comparisons;
    long long fewest;

public:
    /// @param fewest_ comparisons that it takes to win
    ReadingContest(MotionConvention taken_for, std::vector<Comparison>& notes, long long fewest_ = 20)
        : all(readings(taken_for)), comparisons(notes), fewest(fewest_) {
        comparisons.resize(all.size() * all.size());
    }
    /// Calls f(comparison, one, other) for each pair of the numbers of readings.
    void for_each_pair(auto&& f) {
        for (std::size_t a = 0; a < all.size(); ++a)
            for (std::size_t b = 0; b < a; ++b) f(comparisons[a * all.size() + b], a, b);
    }
    [[nodiscard]] std::vector<Reading> const& entrants() const { return all; }
    [[nodiscard]] Reading const& reading(std::size_t i) const { return all[i]; }
    [[nodiscard]] std::size_t best() const {
        std::size_t best = 0;
        for (std::size_t i = 1; i < all.size(); ++i)
            if (won(i, best)) best = i;
        return best;
    }
    /// Whether one beats the pipeline's, and all others that differ from that in as little.
    [[nodiscard]] bool is_winner(std::size_t one) const {
        for (std::size_t i = 1; i < all.size(); ++i)
            if (i != one && mistakes_in(i) <= mistakes_in(one) && comparison(one, i).apart >= fewest && !won(one, i)) return false;
        return one > 0 && won(one, 0) && comparison(one, 0).first >= fewest;
    }
    [[nodiscard]] Comparison comparison(std::size_t a, std::size_t b) const {
        if (a > b) return comparisons[a * all.size() + b];
        auto const turned = comparisons[b * all.size() + a];
        return {turned.second, turned.first, turned.apart};
    }
    [[nodiscard]] bool is_scaled(std::size_t i) const { return all[i].scale < 1.f || all[i].scale > 1.f; }

private:
    [[nodiscard]] std::size_t mistakes_in(std::size_t i) const {
        return mistakes_of(all[i].convention, all[0].convention).size() + (is_scaled(i) ? 1 : 0);
    }
    /// With a margin: disoccluded pixels match neither, or one by chance.
    [[nodiscard]] bool won(std::size_t a, std::size_t b) const {
        return comparison(a, b).first >= 8 && comparison(a, b).first > 4 * comparison(a, b).second;
    }
};

inline void report_convention(MotionConvention convention, Observation const& seen, std::string const& evidence,
                              std::vector<Finding>& findings) {
    auto const factor = correction(convention, seen.convention, seen.size);
    std::string swapped;
    if (convention.points != seen.convention.points) swapped = ", or swap the current and the previous matrix where it is computed,";
    auto const wrong = mistakes_of(convention, seen.convention);
    findings.push_back({wrong.front(),
                        evidence,
                        "multiply motion by " + pair(static_cast<double>(factor.x), static_cast<double>(factor.y)) + swapped +
                            " or give the pipeline Supplied<" + code_of(convention) + ">{}",
                        {wrong.begin() + 1, wrong.end()}});
}

/// A factor in time or size.
inline void report_scale(float factor, std::string const& evidence, std::vector<Finding>& findings) {
    findings.push_back({Mistake::motion_scale, evidence,
                        "multiply motion by " + number(static_cast<double>(factor)) +
                            ": it is in pixels of this picture, from this frame to the one before it"});
}

/// The same too much in every vector.
inline void report_offset(glm::vec2 offset, std::string const& evidence, std::vector<Finding>& findings) {
    findings.push_back(
        {Mistake::motion_offset,
         evidence + "; all have " + pair(static_cast<double>(offset.x), static_cast<double>(offset.y)) + " pixels too much in their motion",
         "subtract it: both ends of a motion vector are places of the same kind, both of pixels' centres or both of corners"});
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
