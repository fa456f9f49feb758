#pragma once

#include <string_view>

namespace quell::bench {

/// Runs the presets against each other at 1920x1080, one frame of each executor in turn, so that whatever else the machine does meets all
/// alike, and prints tables of medians: presets with their ratios, and passes. Ratios are medians of each turn's ratio.
/// @param wanted a preset's name, or nothing for all
void print_summary(std::string_view wanted, int rounds);

} // namespace quell::bench
