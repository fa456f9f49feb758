#pragma once

#include <quell/diagnose/guide_blocks.hpp>
#include <quell/diagnose/hypotheses/motion/readings.hpp>
#include <quell/diagnose/notes.hpp>

#include <limits>
#include <string>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

inline std::string parts_of_the_picture(long long count) { return std::to_string(count) + " parts of the picture"; }

/// Moves a block on by the vectors of this frame, in all readings.
inline void move_on(Observation const& seen, GuideBlock& block) {
    auto const all = readings(seen.convention);
    auto const unknown = glm::vec2(std::numeric_limits<float>::quiet_NaN());
    block.ways.resize(all.size()), block.steps.resize(all.size());
    for (std::size_t r = 0; r < all.size(); ++r) {
        auto const factor = all[r].scale * correction(all[r].convention, seen.convention, seen.size);
        for (std::size_t i = 0; i < 9; ++i) {
            auto& step = block.steps[r][i];
            auto& way = block.ways[r][i];
            auto const middle = [](std::size_t of) { return static_cast<int>(of) * GuideBlock::third + GuideBlock::third / 2; };
            // Each pixel's vector says where it was. Which pixel is the one that was here takes guesses.
            for (int guess = 0; guess < 2 && all_finite(step); ++guess) {
                auto const at = pixel_of(block, middle(i % 3), middle(i / 3), seen.size) + glm::ivec2(glm::round(way + step));
                step = is_inside(seen.size, at) ? -factor * vec2_at(seen.motion, at.x, at.y) : unknown;
                if (!(glm::length(step) < static_cast<float>(seen.size.width))) step = unknown;
            }
            way += step;
        }
    }
}

/// Whether motion says that nothing moved by a pixel yet.
inline bool is_at_rest(GuideBlock const& block) { return !block.ways.empty() && glm::length(block.ways.front()[4]) < 1.f; }

/// How many blocks are where a reading says, and not a little beside: it may only be nearer to the truth than another.
/// @param offset that motion has too little in every frame
/// @param reach how far to look, in steps
inline Tally fitting(Observation const& seen, BlockNotes const& notes, std::size_t reading, glm::vec2 offset, int reach) {
    Tally there;
    for (auto const& block : notes.blocks) {
        BlockSearch search(seen, block, notes);
        auto ways = block.ways[reading];
        for (auto& way : ways) way += static_cast<float>(notes.age) * offset;
        auto const rest = search.at(ways);
        search.far_around(ways, 6.f);
        search.around(ways, reach, reach == 1 ? 2.f : 1.5f);
        if (!rest || search.tells()) there.add(search.may_be(rest));
    }
    return there;
}

/// By how much all blocks are beside the place where motion says, in one frame: the median.
inline glm::vec2 common_offset(Observation const& seen, BlockNotes const& notes) {
    std::vector<float> xs, ys;
    for (auto const& block : notes.blocks) {
        BlockSearch search(seen, block, notes);
        search.far_around(block.ways[0], 8.f);
        auto const best = search.around(block.ways[0], 6, 1.f);
        if (search.tells()) xs.push_back(best.x), ys.push_back(best.y);
    }
    return glm::vec2(median(xs), median(ys)) / static_cast<float>(notes.age);
}

/// Whether a way is none, but for what rounding leaves of it: Cycles writes up to 2.7e-5 pixels where it does not tell a zoom.
inline bool is_no_way(glm::vec2 way) { return glm::length(way) < 1e-2f; }

/// Vectors of 0 in a picture most of which moves. A part of it may be a texture that moves, such as a screen.
inline void find_motion_at_rest(Observation const& seen, BlockNotes const& notes, std::vector<Finding>& findings) {
    Tally moved;
    for (auto const& block : notes.blocks) {
        if (!std::ranges::all_of(block.ways.front(), is_no_way)) continue;
        BlockSearch search(seen, block, notes);
        auto const rest = search.at(block.ways.front());
        search.far_around(block.ways.front(), 8.f);
        auto const best = search.around(block.ways.front(), 6, 2.f);
        if (search.tells()) moved.add(!search.may_be(rest) && glm::length(best) > 1.5f * search.step());
    }
    if (moved.yes < 8 || moved.share() < 0.6 || 4 * moved.asked < 3 * static_cast<long long>(notes.blocks.size())) return;
    findings.push_back({Mistake::motion_zero,
                        "of " + parts_of_the_picture(moved.asked) + " where motion is 0, depth, normals and albedo show that " +
                            std::to_string(moved.yes) + " moved in the last " + std::to_string(notes.age) + " frames",
                        "compute motion with the previous frame's matrices, which must not be those of this frame, and fill the channel; "
                        "Blender writes no vectors where motion blur is on"});
}

/// Adds to the notes how the readings fit to this frame.
inline void compare_readings(Observation const& seen, GuideBlock const& block, BlockNotes& notes) {
    BlockSearch search(seen, block, notes);
    search.far_around({}, 5.f), search.far_around({}, 10.f);
    std::vector<std::optional<float>> rests;
    for (auto const& ways : block.ways) rests.push_back(search.at(ways));
    if (!search.tells()) return;
    ReadingContest contest(seen.convention, notes.comparisons);
    contest.for_each_pair([&](Comparison& comparison, std::size_t a, std::size_t b) {
        float const one = search.rest_of(rests[a]), other = search.rest_of(rests[b]);
        comparison.apart += !(glm::length(block.ways[a][4] - block.ways[b][4]) < 2.f);
        comparison.first += one < other - search.margin(), comparison.second += other < one - search.margin();
    });
}

/// Where the blocks are if not where motion leads.
/// @param own how many are there
/// @param is_old whether they are old enough to tell motion that is half as long, or beside by half a pixel
inline void find_other_motion(Observation const& seen, BlockNotes& notes, Tally own, bool is_old, std::vector<Finding>& findings) {
    for (auto const& block : notes.blocks) compare_readings(seen, block, notes);
    ReadingContest const contest(seen.convention, notes.comparisons, 8);
    auto const best = contest.best();
    bool const is_winner = contest.is_winner(best), is_scaled = contest.is_scaled(best);
    if (!is_old && (!is_winner || is_scaled)) return;
    auto const there = is_winner ? fitting(seen, notes, best, {}, 2) : own;
    auto const offset = !is_winner || is_scaled ? common_offset(seen, notes) : glm::vec2(0.f);
    auto const beside = glm::length(offset) > 0.2f ? fitting(seen, notes, 0, offset, 2) : Tally{};
    if (beside.share() > 0.7 && beside.share() > there.share() + 0.1 && beside.share() > own.share() + 0.5)
        return report_offset(-offset,
                             percent(beside.share()) + " of " + parts_of_the_picture(beside.asked) +
                                 " are beside the place where motion leads, by depth, normals and albedo, and " + percent(own.share()) +
                                 " are there",
                             findings);
    // Whatever is wrong, shorter vectors lead less astray.
    bool const is_sure = is_scaled ? there.share() > 0.75 && there.share() > own.share() + 0.3 : there.share() > 0.6;
    if (!is_winner || !is_sure) return;
    auto const [convention, scale] = contest.reading(best);
    auto const factor = scale * correction(convention, seen.convention, seen.size);
    auto const counts = contest.comparison(best, 0);
    auto const text = parts_of_the_picture(counts.first) + " are where motion times " +
                      pair(static_cast<double>(factor.x), static_cast<double>(factor.y)) +
                      " leads and not where motion does, by depth, normals and albedo, " + std::to_string(counts.second) +
                      " the other way round, in all frames so far";
    if (is_scaled)
        report_scale(scale, text, findings);
    else
        report_convention(convention, seen, text, findings);
}

/// Motion that the guides contradict, whether or not there is a camera. Slow motion shows after some frames: blocks are looked for in the
/// fourth frame after theirs, and where motion is 0 in the first, second, fourth, eighth and sixteenth.
inline void find_motion_by_blocks(Observation const& seen, BlockNotes& notes, bool follows, std::vector<Finding>& findings) {
    if (!seen.motion) return;
    if (!follows) notes.blocks.clear();
    for (auto& block : notes.blocks) move_on(seen, block);
    ++notes.age;
    bool const rests = std::ranges::all_of(notes.blocks, is_at_rest), is_old = notes.age >= (rests ? 16 : 4);
    bool const is_due = is_old || (rests && (notes.age & (notes.age - 1)) == 0);
    if (!notes.blocks.empty() && is_due) {
        auto const own = fitting(seen, notes, 0, {}, 1);
        if (own.share() > 0.6)
            notes.comparisons.clear();
        else if (own.asked >= 8) {
            find_motion_at_rest(seen, notes, findings);
            if (findings.empty()) find_other_motion(seen, notes, own, is_old, findings);
        }
    }
    if (is_old || notes.blocks.empty()) notes.blocks = blocks_of(seen), notes.jitter = seen.camera.jitter, notes.age = 0;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
