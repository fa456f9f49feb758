#pragma once

#include <quell/diagnose/hypotheses/motion/motion_hypotheses.hpp>

#include <utility>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Median offset of motion vectors from those of static surfaces, and the share of pixels that have it.
struct CommonOffset {
    glm::vec2 offset{};
    Tally sharing, without;

    explicit CommonOffset(ComparedMotions const& pairs) {
        std::vector<float> xs, ys;
        for (auto const& pair : pairs) xs.push_back(pair.found.x - pair.expected.x), ys.push_back(pair.found.y - pair.expected.y);
        offset = {median(xs), median(ys)};
        for (auto const& pair : pairs) {
            auto const rest = pair.found - pair.expected;
            float const allowed = 0.02f + 0.01f * glm::length(pair.expected);
            sharing.add(glm::length(rest - offset) < allowed), without.add(glm::length(rest) < allowed);
        }
    }
    /// Of all that is seen, and clearly more common than none.
    [[nodiscard]] bool is_everywhere(bool camera_moves) const {
        return glm::length(offset) > 0.1f && sharing.share() > (camera_moves ? 0.6 : 0.85) && without.share() < 0.02;
    }
    /// At most 1.5 pixels per axis, as the jitter of two frames may differ, and clearly more common than no offset.
    [[nodiscard]] bool is_jitter() const {
        bool const subpixel = std::abs(offset.x) < 1.5f && std::abs(offset.y) < 1.5f && glm::length(offset) > 0.05f;
        return subpixel && sharing.share() > 0.6 && sharing.share() > without.share() + clear_margin;
    }
};

inline std::string jitter_remedy(MotionConvention taken_for) {
    if (taken_for.jitter == MotionConvention::Jitter::left_in)
        return "leave .jitter out of the MotionConvention: the vectors have none in them, or camera.jitter is not what they have";
    taken_for.jitter = MotionConvention::Jitter::left_in;
    return "project with matrices without jitter where motion is computed, or set camera.jitter and give the pipeline Supplied<" +
           code_of(taken_for) + ">{}";
}

/// Whether an offset looks like jitter: it is the change of camera.jitter, or it reverses. Sliding surfaces keep their direction and match
/// that change only by chance.
inline bool looks_like_jitter(glm::vec2 offset, glm::vec2 before, glm::vec2 change) {
    bool const is_change = std::min(glm::length(offset - change), glm::length(offset + change)) < 0.05f;
    return (glm::length(change) > 0.05f && is_change) || glm::dot(offset, before) < 0.f;
}

/// The change of jitter in every vector, in two consecutive frames. Returns whether it is there, or may be.
inline bool find_motion_jitter(Observation const& seen, ComparedMotions const& pairs, std::vector<Finding>& findings) {
    CommonOffset const common(pairs);
    auto const offset = common.is_jitter() ? common.offset : glm::vec2(0.f);
    auto const before = std::exchange(seen.notes().motion_offset, offset);
    auto const change = seen.camera.jitter - seen.camera_then.jitter;
    auto& in_a_row = seen.notes().jittered_in_a_row;
    in_a_row = looks_like_jitter(offset, before, change) && common.is_jitter() ? in_a_row + 1 : 0;
    // Neither a large sliding object nor an unreported camera movement is jitter.
    if (in_a_row < 2) return common.is_jitter() && glm::length(offset - before) > 0.1f;
    findings.push_back({Mistake::motion_jitter,
                        percent(common.sharing.share()) + " of " + std::to_string(pairs.size()) + " surface pixels have " +
                            pair(offset.x, offset.y) + " pixels too much in their motion; camera.jitter changed by " +
                            pair(change.x, change.y),
                        jitter_remedy(seen.convention)});
    return true;
}

/// The same offset in every vector of three frames, whatever the camera does: a place that is counted from another corner of the pixel or
/// from another pixel. Returns whether it is there, or may be.
inline bool find_motion_offset(Observation const& seen, ComparedMotions const& pairs, bool camera_moves, std::vector<Finding>& findings) {
    CommonOffset const common(pairs);
    auto& notes = seen.notes();
    bool const everywhere = common.is_everywhere(camera_moves), same = glm::length(common.offset - notes.constant_offset) < 0.02f;
    notes.offset_in_a_row = !everywhere ? 0 : same ? notes.offset_in_a_row + 1 : 1;
    notes.constant_offset = common.offset;
    if (notes.offset_in_a_row < 2) return everywhere && notes.offset_in_a_row > 0 && !camera_moves;
    report_offset(common.offset,
                  percent(common.sharing.share()) + " of " + std::to_string(pairs.size()) +
                      " surface pixels are beside the place where depth and cameras say, by the same as in the last frame, and " +
                      percent(common.without.share()) + " are there",
                  findings);
    return true;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
