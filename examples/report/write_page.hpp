#pragma once

#include "report/page_parts.hpp"

#include <filesystem>
#include <functional>
#include <ostream>
#include <string>

namespace quell::examples {

/// Writes a page with each {{mark}} of its HTML replaced: `title`, `style` and `scripts` here, any other by `write_mark`. The file appears
/// whole or not at all. Throws quell::Error where it can't be written.
void write_page(std::filesystem::path const& file, PageParts const& page, std::string const& title,
                std::function<void(std::ostream& out, std::string_view mark)> const& write_mark);

/// JSON in which no < is left, so that no </script> or <!-- in a string can end the element that it stands in.
[[nodiscard]] std::string without_angle_brackets(std::string const& json);

} // namespace quell::examples
