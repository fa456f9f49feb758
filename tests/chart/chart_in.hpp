#pragma once

#include "../temporary_folder.hpp"

#include <doctest/doctest.h>

#include <map>
#include <sstream>
#include <vector>

// Reads what quell-chart has written.
namespace quell::bench {

using Cells = std::map<std::string, std::string>; ///< by column

inline std::vector<std::string> split(std::string const& text, char at) {
    std::vector<std::string> parts;
    std::istringstream in(text + at);
    for (std::string part; std::getline(in, part, at);) parts.push_back(part);
    return parts;
}

/// The rows of chart.csv by method.
inline std::map<std::string, Cells> chart_in(std::filesystem::path const& folder) {
    auto lines = split(tests::bytes_of(folder / "chart.csv"), '\n');
    auto const columns = split(lines.at(0), ',');
    std::map<std::string, Cells> rows;
    for (std::size_t i = 1; i < lines.size() && !lines[i].empty(); ++i) {
        auto const cells = split(lines[i], ',');
        REQUIRE(cells.size() == columns.size());
        Cells row;
        for (std::size_t c = 0; c < cells.size(); ++c) row[columns[c]] = cells[c];
        rows[cells.at(2)] = row;
    }
    return rows;
}

} // namespace quell::bench
