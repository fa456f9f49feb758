#pragma once

#include <gauntlet/shot.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace quell::gauntlet {

/// What the command line of quell-gauntlet says.
struct GauntletOptions {
    std::vector<std::string> names;               ///< of situations; empty: all
    std::vector<std::filesystem::path> sequences; ///< of files, in place of situations
    std::vector<int> samples;                     ///< empty: those of each situation
    Making making;
    std::filesystem::path out = "out/gauntlet", denoise, stored;
    std::filesystem::path store; ///< where the figures of this program go, for others to be held against; empty: nowhere
    int threads = 0;
    bool smallest = false, check = false, keep = false, quiet = false, list = false;
};

/// Nothing where help was asked for, which has then been printed.
/// @throws Error for a command line that can't be used
[[nodiscard]] std::optional<GauntletOptions> gauntlet_options(int argc, char const* const* argv);

} // namespace quell::gauntlet
