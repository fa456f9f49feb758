#pragma once

#include "judge.hpp"

#include <quell/io/exr_image.hpp>

namespace quell::bench {

/// A sequence as files, for a third party's programs to denoise. They lie in a folder of their own that goes when this goes.
class ExternalRuns {
public:
    ExternalRuns() = default;
    ExternalRuns(ExternalRuns const&) = delete;
    ExternalRuns& operator=(ExternalRuns const&) = delete;
    ~ExternalRuns();

    /// Writes the next noisy frame.
    void write(int frame, io::ExrImage const& image);
    /// Runs a program over all frames written and measures R, G, B of its output. Its time is what it says
    /// in a line "milliseconds per frame: N", or else that of the whole run, start and files included, over the number of frames; what
    /// memory it takes isn't known.
    /// @throws Error where it fails, or leaves out a scored frame
    [[nodiscard]] Row run(External const& external, Judge const& judge);

private:
    std::filesystem::path folder{};
    int frames = 0, runs = 0;

    [[nodiscard]] double milliseconds_of(External const& external, std::filesystem::path const& out) const;
};

/// @throws Error where one of them has a method's name, or its picture that of a method
void check_differ(std::vector<External> const& externals, std::string const& method);

/// The command with {in} and {out} replaced, quoted for a shell where they must be.
[[nodiscard]] std::string filled_in(std::string command, std::string const& in, std::string const& out);

} // namespace quell::bench
