#pragma once

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>

// Data of others lies beside the repository, where it is there at all. Cases that need it are of doctest's suite "shared data", which
// quell_shared_data_test in CMakeLists.txt makes a test of its own.
namespace quell::tests {

/// Whether a case was left out. Then main returns 77 where nothing failed, which CTest takes for skipped.
inline bool skipped = false;

/// The path of such data; empty, with a line that says so, where it isn't there.
inline std::filesystem::path shared(std::string const& name) {
    auto const* const folder = std::getenv("QUELL_SHARED");
    auto const path = std::filesystem::path(folder ? folder : "../shared") / name;
    if (std::filesystem::exists(path)) return path;
    skipped = true;
    std::cout << "skipped: there is no " << path.string() << " (QUELL_SHARED names the folder)" << std::endl;
    return {};
}

} // namespace quell::tests
