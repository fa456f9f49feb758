#pragma once

#include <string>

namespace quell::examples {

/// A text as a cell of a CSV file: in quotes where it has commas, quotes or line ends of its own (RFC 4180).
[[nodiscard]] std::string csv_cell(std::string const& text);

} // namespace quell::examples
