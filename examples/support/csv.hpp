#pragma once

#include <string>

namespace quell::examples {

/// A text as a cell of a CSV file: in quotes where it has commas, quotes or line ends of its own (RFC 4180).
[[nodiscard]] inline std::string csv_cell(std::string const& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (char const c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + "\"";
}

} // namespace quell::examples
