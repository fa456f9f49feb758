#pragma once

#include "results.hpp"

#include <denoise/denoiser.hpp>
#include <quell/io/sequence_names.hpp>
#include <support/frame_pattern.hpp>

#include <functional>
#include <optional>

namespace quell::bench {

/// A preset of quell-denoise, by the name that its row has.
struct FileMethod {
    std::string name;
    examples::Preset preset;
    int later_frames = 0;
};

/// A sequence of files to chart: what there is of it on disk, and what can be made of that.
struct FileSequence {
    std::string scene; ///< its folder's name
    examples::FramePattern in, reference;
    std::optional<io::SequenceNames> map;
    examples::FrameRange range;
    std::vector<long long> scored; ///< the frames that have a reference
    Extent size;
    std::vector<FileMethod> methods; ///< the presets whose channels the files have; `none` in any case

    [[nodiscard]] int frames() const { return static_cast<int>(range.last - range.first + 1); }
    [[nodiscard]] long long steps() const { return static_cast<long long>(methods.size()) * frames(); }
};

/// Looks at all sequences of the command line.
/// @throws Error where there are no frames, some are missing or have no reference, or two sequences would have the same name
[[nodiscard]] std::vector<FileSequence> file_sequences(ChartOptions const& options);

/// Charts a sequence. Errors are of the whole picture, displayed, in the frames that have a reference; times are of denoising alone.
/// @param progress called before each frame
void chart_files(ChartOptions const& options, FileSequence const& sequence, std::function<void(std::string const& doing)> const& progress,
                 Results& results);

} // namespace quell::bench
