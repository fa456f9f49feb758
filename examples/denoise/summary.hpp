#pragma once

#include <quell/image/extent.hpp>
#include <quell/metrics/metric.hpp>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace quell::examples {

/// Scores of the frames that have a reference.
using FrameScores = std::vector<std::pair<long long, metrics::Errors>>;

/// One of several views of the files.
struct SummaryOfView {
    std::string name;
    FrameScores scores;
};

/// What quell-denoise has done.
struct Summary {
    std::string preset, preset_reason, signal, renderer;
    std::vector<long long> written, skipped;      ///< numbers of frames; without --out, those that were denoised
    long long warm_up_frames = 0;                 ///< denoised and not written
    long long missing_samples = 0;                ///< that were not finite, or negative
    Extent size{};                                ///< of the frames that come out; without pixels where none did
    std::string upsampled_by;                     ///< resolve or bicubic; empty: not at all
    double milliseconds = 0;                      ///< of denoising alone
    double bytes_per_pixel = 0;                   ///< of history and scratch: of all views' histories, and one view's scratch
    std::map<std::string, double> layout_changes; ///< of each signal in a frame: see LayoutChanges
    std::vector<std::string> findings, not_checked, remarks;
    std::vector<std::string> why;     ///< what stages did, where that was asked for
    FrameScores scores;               ///< of the first view
    std::vector<SummaryOfView> views; ///< all, where there are several
    std::optional<std::string> error; ///< why it stopped
};

/// One JSON object on a line, with all of it.
[[nodiscard]] std::string json_of(Summary const& summary);
/// Writes the sentences for people on stderr.
void say(Summary const& summary);

} // namespace quell::examples
