#pragma once

#include "row.hpp"

#include <filesystem>

namespace quell::bench {

/// Writes the chart as a page that works offline, from a file: points to be hovered over, filtered by scene and effect, switched between
/// measures, and the picture behind each. The pictures are the files that the rows name, from the page's folder.
/// @throws Error where the file can't be written
void write_chart_page(std::vector<Row> const& rows, std::filesystem::path const& file);

} // namespace quell::bench
