#pragma once

#include <gauntlet/limits.hpp>

#include <filesystem>

namespace quell::gauntlet {

/// Writes gauntlet.csv, a line a row, and frames.csv.
void write_tables(std::vector<Row> const& rows, std::vector<Verdict> const& verdicts, std::filesystem::path const& folder);
/// A line of gauntlet.csv, and its columns.
[[nodiscard]] std::string line_of(Row const& row, Verdict const& verdict);
inline constexpr auto row_columns = "situation,samples,input,quick,default,over_quick,over_input,good_windows,right_over_before,held";

/// Writes index.html: the table, and the worst pictures.
void write_page(std::vector<Row> const& rows, std::vector<Verdict> const& verdicts, std::filesystem::path const& folder);

} // namespace quell::gauntlet
