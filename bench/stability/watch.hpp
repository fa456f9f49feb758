#pragma once

#include "results.hpp"
#include "scored_sequence.hpp"

#include <denoise/presets.hpp>

#include <string>
#include <vector>

namespace quell::stability {

/// What a method may remember.
struct Memory {
    enum class Kind { all, none, since } kind = Kind::all;
    int start = 0; ///< for `since`: the frame before which all is forgotten

    /// The number by which the history of a frame is known: where numbers don't follow each other, history starts afresh.
    [[nodiscard]] long long number(int frame) const {
        if (kind == Kind::none) return 2LL * frame;
        return kind == Kind::since && frame >= start ? frame + 1000LL : frame;
    }
};

/// What a method made of the scored frames of a sequence: linear pictures.
using Pictures = std::vector<metrics::Picture>;
[[nodiscard]] Pictures watch(examples::Preset const& preset, ScoredSequence const& sequence, Memory memory = {}, int threads = 0);

/// Compares the scored frames in the sequence's masks. The results get them too. Frames without a single pixel that counts are left out.
FrameErrors record(Results& results, std::string const& subject, std::string const& method, ScoredSequence const& sequence,
                   Pictures const& pictures);
/// The same of what a preset makes of the sequence, under the preset's name.
FrameErrors record(Results& results, std::string const& subject, examples::Preset const& preset, ScoredSequence const& sequence,
                   int threads);
/// Compares one frame. A picture that isn't finite has no error, and is left out. @param wanted, @param shown linear
void record(FrameErrors& errors, std::string const& subject, std::string const& method, int frame, metrics::Picture const& wanted,
            metrics::Picture const& shown);

/// The limit of a ratio that promises "no worse": 1, but for rounding.
inline constexpr double no_worse = 1.0001;

/// The greatest ratio of two methods' RMSE in the same frame, from a frame on.
[[nodiscard]] double worst_ratio(FrameErrors const& a, FrameErrors const& b, int from = 0);
/// The ratio of the mean RMSE of two methods.
[[nodiscard]] double mean_ratio(FrameErrors const& a, FrameErrors const& b);

} // namespace quell::stability
