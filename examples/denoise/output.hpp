#pragma once

#include <denoise/layers.hpp>
#include <denoise/options.hpp>
#include <support/frame_pattern.hpp>

#include <quell/diagnose/debug_channels.hpp>

#include <optional>
#include <set>

namespace quell::examples {

/// Where the results of quell-denoise go.
class Output {
    FramePattern in;
    std::optional<FramePattern> pattern;
    LayerChoice layers;
    bool upsamples = false;         ///< whether the picture alone is written, at another size
    bool one_signal = false;        ///< whether a signal is written in place of the picture
    std::set<std::string> lossless; ///< parts that can't be packed as they were

public:
    /// Makes the folder. @param numbers of the frames that may be written
    /// @throws Error where a result would take the place of an input or a reference, or can't be written
    Output(DenoiseOptions const& options, FramePattern const& input, std::vector<long long> const& numbers);

    /// Whether the output of a frame is there, and whole.
    [[nodiscard]] bool has(long long number) const;
    /// Makes sure that there are the layers to write. @throws Error naming the one that there is not
    /// @param first number of a frame
    /// @param names by which files are read, where they are known
    void check(long long first, std::optional<io::SequenceNames> const& names) const;
    /// Makes sure that a frame's output can be written. @throws Error where its tiles have several levels
    /// @param names by which files are read
    void check_levels(long long number, io::SequenceNames const& names) const;
    /// Takes what was denoised of a view of a frame.
    void add(long long number, DenoisedFrame& frame, io::SequenceNames const& names);
    /// Writes the input's file again, with what was denoised in its place.
    void write(long long number);
    /// @param prefix of the images' names
    void write_views(long long number, std::string const& view, std::string const& prefix,
                     std::vector<std::pair<std::string, DebugImage>> const& images) const;
    /// @param prefix of the image's name
    void write_why(long long number, std::string const& prefix, metrics::Picture const& image) const;
    /// @param table of all views
    void write_why(long long number, std::string const& table) const;
    /// What the user should know, a line each.
    [[nodiscard]] std::vector<std::string> remarks() const;

private:
    std::optional<io::ExrChanges> changes; ///< of the frame's views so far

    [[nodiscard]] std::optional<std::string> layer_for(io::SequenceNames const& names) const;
};

} // namespace quell::examples
