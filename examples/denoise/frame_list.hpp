#pragma once

#include <string>
#include <vector>

namespace quell::examples {

/// The numbers in a list such as 1-48,60 or 1-99x2 (every second one), ascending, each once.
/// @throws Error for anything else
[[nodiscard]] std::vector<long long> frames_in(std::string const& text);

/// One of several parts of the frames, of which a farm's jobs have one each.
struct Chunk {
    long long number = 1; ///< from 1 to count
    long long count = 1;  ///< parts that the frames are split into
};
/// The chunk in a text such as 2/6. @throws Error for anything else
[[nodiscard]] Chunk chunk_in(std::string const& text);
/// The frames of a chunk: parts in a row, whose lengths differ by one at most. Empty where there are more chunks than frames.
[[nodiscard]] std::vector<long long> part_of(std::vector<long long> const& frames, Chunk const& chunk);

/// A frame that is denoised.
struct Step {
    long long number;
    bool is_written;     ///< or only warms up the history of later ones
    bool begins = false; ///< whether history starts afresh
    friend bool operator==(Step const&, Step const&) = default;
};

/// Frames before each written one that its history is warmed up with.
struct WarmUp {
    long long frames = 0;
    bool whatever_there_is = false; ///< end at a gap in the files: nobody asked for a number of frames
};
/// The frames to denoise so that these can be written.
/// @param written numbers, ascending
/// @param there   numbers of the files that there are, ascending
[[nodiscard]] std::vector<Step> steps_for(std::vector<long long> const& written, WarmUp const& warm_up,
                                          std::vector<long long> const& there);

} // namespace quell::examples
