#pragma once

#include <optional>
#include <string>
#include <vector>

namespace quell::examples {

/// What the command line of quell-denoise says.
struct DenoiseOptions {
    std::string in, out, reference, map;
    std::string preset; ///< empty: what suits the files
    std::string signal; ///< that is denoised by itself; empty: the picture
    std::optional<long long> first, last;
    std::string frames;              ///< a list; empty: from first to last
    std::string chunk;               ///< a part of them, as 2/6; empty: all
    std::optional<long long> warmup; ///< without one, what the preset remembers
    std::vector<std::string> layers; ///< to write; empty: all
    std::optional<int> extra_frames; ///< later ones that each frame is denoised with
    int threads = 0;
    std::optional<float> field_of_view; ///< vertical, degrees
    std::optional<float> upsample;      ///< how many times larger than the input; empty: the picture takes the input's place
    std::optional<float> shutter;       ///< of all frames, whatever the map and the files say
    std::vector<std::string> debug_views;
    std::optional<std::vector<std::string>> stages; ///< names of what is done besides; empty: what the preset has
    std::string device = "cpu";                     ///< or "cuda"
    std::string isa;                                ///< the instruction set to run; empty: the best that the machine has
    bool why = false, keep_alpha = false, quick = false, quiet = false, list = false, plan = false, diagnose = false, skip_existing = false,
         json = false;
};

/// Nothing where help or the version was asked for, which has then been printed.
/// @throws Error for a command line that can't be used
[[nodiscard]] std::optional<DenoiseOptions> denoise_options(int argc, char const* const* argv);

} // namespace quell::examples
