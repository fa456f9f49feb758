#pragma once

#include "cases.hpp"

#include <quell/image/extent.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace quell::bench {

/// A third party's program that is charted as a method.
struct External {
    std::string name, command; ///< the command has {in} and {out} in it
};

/// A sequence of files that is charted as a scene: patterns such as dir/frame.%04d.exr.
struct Files {
    std::string in, reference;
};

/// What the command line of quell-chart says.
struct ChartOptions {
    std::vector<SceneEffect> cases; ///< none where there are files
    std::vector<Files> files;
    std::string map;                      ///< how they name their channels; empty: by what they are
    std::optional<long long> first, last; ///< of their frames; what isn't given is what there is
    std::filesystem::path out = "out/chart";
    Extent size{480, 270};
    int frames = 41;            ///< more than first_scored, or than first_timed if only times are wanted
    std::string device = "cpu"; ///< what denoises files: cpu or cuda
    int threads = 0;            ///< the number of threads; on the command line 0 means all
    std::uint32_t seed = 0;
    double tolerance = 0; ///< of the references: mean FLIP between two independent halves; 0: by the effect
    bool few = false;     ///< score frames 24, 32 and 40 only
    bool times = false;   ///< score none: there are no references, pictures, plots and page, only times and bytes
    std::vector<External> externals;
    bool quiet = false, list = false, wants_help = false;

    static constexpr int first_scored = 24, pictured = 32;
    static constexpr int first_timed = 8; ///< before it, histories fill and memory is touched for the first time
    /// Numbers of the frames that are compared with a reference.
    [[nodiscard]] std::vector<int> scored_frames() const;
    [[nodiscard]] bool scores(int frame) const;
    /// The scored frame of which pictures are kept.
    [[nodiscard]] int pictured_frame() const;
};

/// @throws Error for a command line that can't be used
[[nodiscard]] ChartOptions chart_options(int argc, char const* const* argv);

} // namespace quell::bench
