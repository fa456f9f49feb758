#pragma once

#include <quell/diagnose/guide_blocks.hpp>
#include <quell/diagnose/hypotheses/motion/readings.hpp>
#include <quell/diagnose/notes.hpp>

#include <string>
#include <utility>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

inline std::string parts_of_the_picture(long long count) { return std::to_string(count) + " parts of the picture"; }

/// Moves a block on by the vectors of this frame, in all readings.
inline void move_on(Observation const& seen, GuideBlock& block) {
    auto const all = readings(seen.convention);
    auto const unknown = glm::vec2(std::numeric_limits<float>::quiet_NaN());
    block.ways.resize(all.size()), block.steps.resize(all.size());
    for (std::size_t r = 0; r < all.size(); ++r) {
        auto const factor = all[r].scale * correction(all[r].convention, seen.convention, seen.size);
        for (std::size_t i = 0; i < GuideBlock::count; ++i) {
            auto& step = block.steps[r][i];
            auto& way = block.ways[r][i];
            // Each pixel's vector says where it was. Which pixel is the one that was here takes guesses.
            for (int guess = 0; guess < 2 && all_finite(step); ++guess) {
                auto const at = pixel_of(block, i, seen.size) + glm::ivec2(glm::round(way + step));
                step = is_inside(seen.size, at) ? -factor * vec2_at(seen.motion, at.x, at.y) : unknown;
                if (!(glm::length(step) < static_cast<float>(seen.size.width))) step = unknown;
            }
            way += step;
        }
    }
}

/// How this frame fits to a block of an earlier one. Adds to the notes.
inline void compare_readings(Observation const& seen, GuideBlock const& block, BlockNotes& notes) {
    BlockSearch search(seen, block);
    auto const jitter_change = seen.camera.jitter - notes.jitter;
    std::vector<std::optional<float>> rests;
    for (auto const& ways : block.ways) rests.push_back(search.moved([&](std::size_t i) { return ways[i] - jitter_change; }));
    bool const rests_by_motion = std::ranges::all_of(block.ways.front(), [](glm::vec2 way) { return way == glm::vec2(0.f); });
    if (rests_by_motion && rests.front() && *rests.front() > 0.25f * search.typical) search.everywhere();
    if (!search.tells()) return;
    float const margin = search.margin();
    auto const rest_of = [&](std::size_t i) { return rests[i].value_or(search.typical); };
    if (rests_by_motion) {
        ++notes.resting_now, notes.moved_now += !search.may_be(rests.front());
        return;
    }
    ReadingContest contest(seen.convention, notes.comparisons);
    contest.for_each_pair([&](Comparison& comparison, std::size_t a, std::size_t b) {
        auto const middle = GuideBlock::count / 2;
        comparison.apart += !(glm::length(block.ways[a][middle] - block.ways[b][middle]) < 2.f);
        comparison.first += rest_of(a) < rest_of(b) - margin, comparison.second += rest_of(b) < rest_of(a) - margin;
    });
}

/// Vectors of 0 in a picture most of which moves. A part of it may be a texture that moves, such as a screen.
inline void find_motion_at_rest(BlockNotes& notes, std::vector<Finding>& findings) {
    bool const moves = notes.moved_now >= 6 && 2 * notes.moved_now > notes.resting_now;
    notes.moved_in_a_row = moves ? notes.moved_in_a_row + 1 : 0;
    if (notes.moved_in_a_row < 2) return;
    findings.push_back({Mistake::motion_zero,
                        "of " + parts_of_the_picture(notes.resting_now) +
                            " where motion is exactly 0, depth, normals and albedo show that " + std::to_string(notes.moved_now) +
                            " moved in the last " + std::to_string(notes.age) + " frames",
                        "compute motion with the previous frame's matrices, which must not be those of this frame, and fill the channel; "
                        "Blender writes no vectors with motion blur on"});
}

/// Whether motion says that nothing moved by a pixel yet.
inline bool is_at_rest(BlockNotes const& notes) {
    return std::ranges::all_of(notes.blocks, [](GuideBlock const& block) {
        return block.ways.empty() || glm::length(block.ways.front()[GuideBlock::count / 2]) < 1.f;
    });
}

/// How many blocks are where a reading says, and not a little beside: it may only be nearer to the truth than another.
/// @param offset that motion has too much in every frame
inline Tally fitting(Observation const& seen, BlockNotes const& notes, std::size_t reading, glm::vec2 offset = {}) {
    Tally there;
    auto const more = static_cast<float>(notes.age) * offset - (seen.camera.jitter - notes.jitter);
    for (auto const& block : notes.blocks) {
        if (block.ways.empty()) continue;
        BlockSearch search(seen, block);
        auto const way_of = [&](std::size_t i) { return block.ways[reading][i] + more; };
        auto const rest = search.moved(way_of);
        search.around(way_of, 2, 1.5f);
        if (search.tells()) there.add(search.may_be(rest));
    }
    return there;
}

/// By how much all blocks are beside the place where motion says, in one frame: the median.
inline glm::vec2 common_offset(Observation const& seen, BlockNotes const& notes) {
    std::vector<float> xs, ys;
    for (auto const& block : notes.blocks) {
        BlockSearch search(seen, block);
        auto const best = search.around([&](std::size_t i) { return block.ways[0][i] - (seen.camera.jitter - notes.jitter); }, 6, 1.f);
        if (search.tells()) xs.push_back(best.x), ys.push_back(best.y);
    }
    return glm::vec2(median(xs), median(ys)) / static_cast<float>(notes.age);
}

/// What the blocks are where motion is not, once they are old enough to tell.
inline void find_other_motion(Observation const& seen, BlockNotes const& notes, ReadingContest const& contest,
                              std::vector<Finding>& findings) {
    auto const best = contest.best();
    bool const is_winner = contest.is_winner(best);
    auto const own = fitting(seen, notes, 0), there = is_winner ? fitting(seen, notes, best) : own;
    auto const offset = !is_winner || contest.is_scaled(best) ? common_offset(seen, notes) : glm::vec2(0.f);
    auto const beside = glm::length(offset) > 0.2f ? fitting(seen, notes, 0, offset) : Tally{};
    if (beside.share() > 0.7 && beside.share() > there.share() + 0.1 && beside.share() > own.share() + 0.5) {
        report_offset(-offset,
                      percent(beside.share()) + " of " + parts_of_the_picture(beside.asked) +
                          " are beside the place where motion leads, by depth, normals and albedo, and " + percent(own.share()) +
                          " are there",
                      findings);
        return;
    }
    // Whatever is wrong, shorter vectors lead less astray.
    bool const is_sure = contest.is_scaled(best) ? there.share() > 0.75 && there.share() > own.share() + 0.3 : there.share() > 0.6;
    if (!is_winner || !is_sure) return;
    auto const [convention, scale] = contest.reading(best);
    auto const factor = scale * correction(convention, seen.convention, seen.size);
    auto const counts = contest.comparison(best, 0);
    auto const text = parts_of_the_picture(counts.first) + " are where motion times " +
                      pair(static_cast<double>(factor.x), static_cast<double>(factor.y)) +
                      " leads and not where motion does, by depth, normals and albedo, " + std::to_string(counts.second) +
                      " the other way round, in all frames so far";
    if (contest.is_scaled(best))
        report_scale(scale, text, findings);
    else
        report_convention(convention, seen, text, findings);
}

/// Motion that the guides contradict, whether or not there is a camera. Slow motion shows after some frames.
inline void find_motion_by_blocks(Observation const& seen, BlockNotes& notes, bool follows, std::vector<Finding>& findings) {
    if (!seen.motion) return;
    if (!follows) notes.blocks.clear();
    for (auto& block : notes.blocks) move_on(seen, block);
    notes.resting_now = notes.moved_now = 0, ++notes.age;
    for (auto const& block : notes.blocks) compare_readings(seen, block, notes);
    find_motion_at_rest(notes, findings);
    ReadingContest const contest(seen.convention, notes.comparisons);
    bool const is_old = notes.age >= (is_at_rest(notes) ? 16 : 4);
    // What is half as long, or beside by half a pixel, takes some frames to be elsewhere.
    bool const is_clear = contest.is_winner(contest.best()) && !contest.is_scaled(contest.best());
    if (!notes.blocks.empty() && (is_old || is_clear)) find_other_motion(seen, notes, contest, findings);
    if (is_old || notes.blocks.empty()) notes.blocks = blocks_of(seen), notes.jitter = seen.camera.jitter, notes.age = 0;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
