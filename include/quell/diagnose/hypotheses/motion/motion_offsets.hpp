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

/// Whether an offset looks like jitter: it is the change of camera.jitter, or that of one end of the vectors, or it reverses. Sliding
/// surfaces keep their direction and match that change only by chance.
inline bool looks_like_jitter(glm::vec2 offset, glm::vec2 before, glm::vec2 now, glm::vec2 then) {
    auto const is = [&](glm::vec2 jitter) {
        return glm::length(jitter) > 0.05f && std::min(glm::length(offset - jitter), glm::length(offset + jitter)) < 0.05f;
    };
    return is(now - then) || (now != then && (is(now) || is(then))) || glm::dot(offset, before) < 0.f;
}

/// The change of jitter in every vector, in two consecutive frames. Returns whether it is there, or may be.
inline bool find_motion_jitter(Observation const& seen, ComparedMotions const& pairs, std::vector<Finding>& findings) {
    CommonOffset const common(pairs);
    auto const offset = common.is_jitter() ? common.offset : glm::vec2(0.f);
    auto const before = std::exchange(seen.notes().motion_offset, offset);
    auto const change = seen.camera.jitter - seen.camera_then.jitter;
    auto& in_a_row = seen.notes().jittered_in_a_row;
    in_a_row = looks_like_jitter(offset, before, seen.camera.jitter, seen.camera_then.jitter) && common.is_jitter() ? in_a_row + 1 : 0;
    // Neither a large sliding object nor an unreported camera movement is jitter.
    if (in_a_row < 2) return common.is_jitter() && glm::length(offset - before) > 0.1f;
    findings.push_back({Mistake::motion_jitter,
                        percent(common.sharing.share()) + " of " + std::to_string(pairs.size()) + " surface pixels have " +
                            pair(offset.x, offset.y) + " pixels too much in their motion; camera.jitter changed by " +
                            pair(change.x, change.y),
                        jitter_remedy(seen.convention)});
    return true;
}

/// How much vectors go to and fro from pixel to pixel of a surface, and how much they change along it.
struct MotionScatter {
    glm::vec2 scatter{}, slope{}; ///< medians, in pixels
    std::size_t asked = 0;

    explicit MotionScatter(Observation const& seen) {
        constexpr int reach = 4;
        std::array<std::vector<float>, 4> all;
        for_each_hit(seen, [&](int x, int y) {
            if (x < reach || x + reach >= seen.size.width) return;
            float const z = seen.depth(0, x, y);
            for (int const i : {-reach, -1, 1, reach})
                if (!(std::abs(seen.depth(0, x + i, y) - z) < 0.03f * static_cast<float>(std::abs(i)) * z)) return;
            auto const at = [&](int i) { return vec2_at(seen.motion, x + i, y); };
            auto const bend = glm::abs(at(0) - 0.5f * (at(-1) + at(1))), rise = glm::abs(at(reach) - at(-reach)) / (2.f * reach);
            if (!all_finite(bend) || !all_finite(rise)) return;
            for (int axis : {0, 1})
                all[static_cast<std::size_t>(axis)].push_back(bend[axis]), all[static_cast<std::size_t>(2 + axis)].push_back(rise[axis]);
        });
        asked = all[0].size();
        scatter = {median(all[0]), median(all[1])}, slope = {median(all[2]), median(all[3])};
    }
    /// About what places anywhere in a pixel make of vectors, and more than the same places make of them where all is well.
    [[nodiscard]] bool is_of_pixels() const {
        auto const one = [](float to_and_fro, float along) { return to_and_fro > 0.12f && to_and_fro < 0.5f && to_and_fro > 2.f * along; };
        return asked >= 100 && one(scatter.x, slope.x) && one(scatter.y, slope.y);
    }
};

/// Vectors one end of which is where the sample is in its pixel, and the other as if it were in the centre. Returns whether it is so.
inline bool find_scattered_motion(Observation const& seen, std::vector<Finding>& findings) {
    MotionScatter const found(seen);
    if (!found.is_of_pixels()) return false;
    findings.push_back({Mistake::motion_jitter,
                        "from pixel to pixel of a surface motion goes to and fro by " +
                            pair(static_cast<double>(found.scatter.x), static_cast<double>(found.scatter.y)) + " pixels (median of " +
                            std::to_string(found.asked) + "), as much as samples lie beside the pixels' centres",
                        "subtract places of the same kind: where the sample's point was less where the sample is, or both for the centre"});
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
