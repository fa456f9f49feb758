#pragma once

#include <quell/diagnose/hypotheses/motion/motion_hypotheses.hpp>

#include <algorithm>
#include <optional>
#include <string>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Sweeps of static surfaces under a moving camera, as fractions of their motion per frame.
struct SweptParts {
    std::vector<float> parts; ///< of sweeps parallel to the motion, negative if opposite
    std::size_t asked = 0;

    SweptParts(Observation const& seen, bool mirrored) {
        StaticMotion const expected(seen.camera, seen.camera_then, seen.size);
        for_each_hit(seen, [&](int x, int y) {
            auto const sweep = vec2_at(seen.sweep, x, y) * glm::vec2(1.f, mirrored ? -1.f : 1.f);
            auto const motion = expected.at(x, y, seen.depth(0, x, y));
            if (!motion || !all_finite(sweep) || !all_finite(*motion) || glm::length(*motion) < 2.f) return;
            ++asked;
            auto const way = -*motion;
            float const part = glm::dot(sweep, way) / glm::dot(way, way);
            if (glm::length(sweep - part * way) < 0.2f * glm::length(sweep)) parts.push_back(part);
        });
    }
    /// Whether most sweeps are the same fraction. Moving objects agree with nothing.
    [[nodiscard]] bool agree_on(float part) const {
        auto const alike = std::ranges::count_if(parts, [&](float p) { return std::abs(p - part) < 0.15f * std::abs(part); });
        return asked >= fewest_pairs && static_cast<double>(alike) > 0.6 * static_cast<double>(asked);
    }
};

/// What is wrong with sweeps that are all such a part of the motion, with y turned round where `mirrored`.
inline std::optional<Finding> sweeps_of(float part, bool mirrored, float shutter) {
    bool const backwards = part<0.f, other_length = std::abs(part)> 1.3f * shutter || std::abs(part) < 0.7f * shutter;
    auto const evidence = "sweeps" + std::string(mirrored ? ", with y the other way," : "") + " are " + number(part) +
                          " of the way that depth and cameras say until the next frame, and frame.shutter is " + number(shutter);
    if (mirrored) {
        Finding finding{Mistake::sweep_y, evidence,
                        "multiply sweep by " + std::string(backwards ? "(-1, 1)" : "(1, -1)") + ": y points down"};
        if (backwards) finding.also = {Mistake::sweep_sign};
        return finding;
    }
    if (backwards)
        return Finding{Mistake::sweep_sign, evidence,
                       "multiply sweep by -1: it leads from where a point is when the shutter opens to where it is when it closes"};
    if (other_length)
        return Finding{Mistake::shutter_differs, evidence,
                       "set frame.shutter to " + number(part) + ", or give sweeps in pixels of that part of the frame time"};
    return std::nullopt;
}

/// Sweeps that point backwards, have y up, or whose duration is not the shutter's, in three consecutive frames: an accelerating camera
/// sweeps more in one frame than it moved before it.
inline void find_wrong_sweeps(Observation const& seen, std::vector<Finding>& findings) {
    std::optional<Finding> finding;
    for (bool const mirrored : {false, true}) {
        SweptParts swept(seen, mirrored);
        float const part = median(swept.parts);
        if (part == 0.f || !swept.agree_on(part)) continue;
        finding = sweeps_of(part, mirrored, seen.shutter);
        break;
    }
    auto& in_a_row = seen.notes().swept_wrongly_in_a_row;
    in_a_row = finding ? in_a_row + 1 : 0;
    if (in_a_row >= 3) findings.push_back(std::move(*finding));
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
