#pragma once

#include "results.hpp"

#include <filesystem>

namespace quell::stability {

/// Draws the error over time of every case: stability.svg with a panel for each, and each by itself as plots/CASE.svg.
/// @throws Error where gnuplot can't
void draw_plots(Results const& results, std::filesystem::path const& folder);

} // namespace quell::stability
