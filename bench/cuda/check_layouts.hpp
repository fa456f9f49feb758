#pragma once

#include <string>
#include <vector>

namespace quell::bench {

/// Compares known_layouts() with what PTX files say of the same jobs, and prints what differs.
/// @return whether all are equal
bool check_layouts(std::vector<std::string> const& ptx_files);

} // namespace quell::bench
