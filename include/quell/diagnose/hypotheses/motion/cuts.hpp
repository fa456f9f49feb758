#pragma once

#include <quell/diagnose/hypotheses/motion/motion_by_blocks.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// How badly the blocks of the last frame are found in this one, where motion says or near: the median of what is left of the difference to
/// other places. Up to about 0.3 of frames that follow each other, 0.6 and more of others; where leaves fly about, anything. Empty where
/// few blocks tell anything.
inline std::optional<float> strangeness(Observation const& seen, BlockNotes const& notes) {
    std::vector<float> left;
    for (auto const& block : notes.blocks) {
        BlockSearch search(seen, block, notes);
        search.at(block.ways.front());
        search.far_around(block.ways.front(), 8.f);
        if (search.share_left() > 0.25f) search.around(block.ways.front(), 6, 2.f), search.around({}, 3, 1.f);
        if (search.is_varied()) left.push_back(search.share_left());
    }
    return left.size() >= 8 ? std::optional(median(left)) : std::nullopt;
}

/// A picture that has nothing to do with the last one, though that one had with the one before it. Returns whether it is so.
inline bool find_cut(Observation const& seen, std::vector<Finding>& findings) {
    auto& notes = seen.notes().last;
    if (!seen.motion) return false;
    for (auto& block : notes.blocks) move_on(seen, block);
    auto const now = seen.has_then ? strangeness(seen, notes) : std::nullopt;
    auto const before = std::exchange(seen.notes().strangeness, now);
    notes.blocks = blocks_of(seen), notes.jitter = seen.camera.jitter;
    if (!now || !before || *now < 0.5f || *before > 0.35f || *now < 2.f * *before) return false;
    findings.push_back(
        {Mistake::cut,
         "of what parts of the last picture differ from their surroundings, " + percent(static_cast<double>(*now)) +
             " are left at the most similar place of this one (median); a frame ago it was " + percent(static_cast<double>(*before)),
         "call forget() of the history before the first frame of each shot, or leave out a number there; give files of several "
         "cameras or shots one by one"});
    return true;
}

/// Forgets what tests of several frames know of those before.
inline Observation without_past(Observation seen) {
    seen.has_then = false, seen.depth_then = {}, seen.camera_then = seen.camera;
    auto& notes = seen.notes();
    notes.blocks = {}, notes.strangeness.reset(), notes.camera_before.reset();
    notes.misfits_in_a_row = notes.jittered_in_a_row = notes.offset_in_a_row = notes.disagreed_in_a_row = 0;
    for (auto const& signal : seen.of_signals) signal.notes->patches.clear(), signal.notes->noise.clear();
    return seen;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
