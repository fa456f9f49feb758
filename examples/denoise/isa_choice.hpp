#pragma once

#include <string>
#include <string_view>
#include <vector>

// No header of quell's: what chooses the code is compiled for the oldest machine.
namespace quell_isa {

/// Code for an instruction set that a program has.
struct Isa {
    std::string_view name; ///< as in -march
    bool runs_here;        ///< on this machine
};

/// Which code to run, or why none can.
struct Choice {
    std::string name{};  ///< of the code; empty where there is an error
    std::string error{}; ///< what was found and what to do, in one line
};

/// What `--isa NAME` among the arguments says, or else the first that runs here.
/// @param built the best first
[[nodiscard]] Choice choose_isa(std::vector<Isa> const& built, std::vector<std::string_view> const& arguments);

} // namespace quell_isa
