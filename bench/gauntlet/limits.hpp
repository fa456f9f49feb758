#pragma once

#include <gauntlet/row.hpp>
#include <gauntlet/stored.hpp>

#include <map>

namespace quell::gauntlet {

/// What is asked of every row.
struct Limits {
    double over_quick = 1.02, over_input = 1.02, right_over_before = 1.03;
    double window_over_quick = 1.05, good_windows = 97, good_windows_of_row = 90; ///< the last two in percent
    double least = 0.002;                                                         ///< frames and windows of less error don't count
    /// Where nothing is broken quell-denoise finds nothing, and makes no remarks but those with these words.
    std::vector<std::string> known_remarks{"pixels have guides that no scene has"};
    int spared_from = 64; ///< samples from which on the input's error is no limit where `--quick` is above it
};

/// How a row's frames stand.
struct Verdict {
    double over_quick = 0, over_input = 0, right_over_before = 0; ///< the worst frame's; 0: none counts
    double good_windows = 100;                                    ///< percent
    long long windows = 0, good = 0;
    std::vector<std::string> broken{}; ///< limits, in words
};

/// @param before figures of an earlier program; where they lack a frame, `--quick` is this program's
[[nodiscard]] Verdict verdict_on(Row const& row, StoredFigures const& before, Limits const& limits = {});

/// Broken limits over all rows of a number of samples, in words.
[[nodiscard]] std::vector<std::string> broken_together(std::vector<Row> const& rows, std::vector<Verdict> const& verdicts,
                                                       Limits const& limits = {});

} // namespace quell::gauntlet
