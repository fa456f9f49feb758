#pragma once

#include <span>
#include <string_view>

namespace quell::examples {

/// A page as written under page/, embedded at build time (embed_page.cmake). Marks such as {{title}} stand where its own text goes.
struct PageParts {
    std::string_view html;
    std::span<std::string_view const> styles, scripts; ///< in the order in which they stand on the page
};

PageParts report_page();

} // namespace quell::examples
