#pragma once

#include "bounds.hpp"

#include <quell/image/extent.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace quell::bench {

/// What the command line of quell-fit says.
struct FitOptions {
    std::string scene;              ///< or, where it is empty, files:
    std::string in, reference, map; ///< patterns such as dir/frame.%04d.exr, and a channel map
    Bounds bounds;
    std::filesystem::path out; ///< the header; empty: none
    Extent size{480, 270};     ///< of a scene; files have their own
    int frames = 41;           ///< of a scene
    int threads = 0;           ///< the number of threads; on the command line 0 means all
    std::uint32_t seed = 0;
    double tolerance = 0.02; ///< of a scene's references: mean FLIP between two independent halves
    bool blur = false;       ///< of a scene: the shutter is open for half of the frame time
    bool quiet = false, list = false, wants_help = false;
};

/// @throws Error for a command line that can't be used
[[nodiscard]] FitOptions fit_options(int argc, char const* const* argv);

} // namespace quell::bench
