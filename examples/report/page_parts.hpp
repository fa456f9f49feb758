#pragma once

#include <span>
#include <string_view>

namespace quell::examples {

/// The page as written under page/, embedded at build time. Marks such as {{title}} stand where a report's own text goes.
std::string_view page_html();
std::string_view page_style();
std::span<std::string_view const> page_scripts(); ///< in the order in which they stand on the page

} // namespace quell::examples
