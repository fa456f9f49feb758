#pragma once

#include "scored_sequence.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace quell::stability {

/// What the command line of quell-stability says.
struct StabilityOptions {
    std::vector<std::string> cases; ///< empty: all
    std::filesystem::path out = "out/stability";
    Making making;
    bool cheap = false, check = false, quiet = false, list = false;
};

/// Nothing where help was asked for, which has then been printed.
/// @throws Error for a command line that can't be used
[[nodiscard]] std::optional<StabilityOptions> stability_options(int argc, char const* const* argv);

} // namespace quell::stability
