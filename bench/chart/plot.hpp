#pragma once

#include "row.hpp"

#include <filesystem>

namespace quell::bench {

/// @throws Error where gnuplot can't be run: better before an hour of work than after it
void require_gnuplot();

/// Draws chart.svg with gnuplot: a panel for each scene and effect, RMSE over milliseconds, the front marked and joined by a line, each
/// parameter's curve thin. The script stays beside it, as chart.gnuplot.
/// @throws Error where it can't
void write_plot(std::vector<Row> const& rows, std::filesystem::path const& folder);

/// That script: gnuplot's language, with the data in it.
[[nodiscard]] std::string plot_script(std::vector<Row> const& rows, std::string const& svg);

} // namespace quell::bench
