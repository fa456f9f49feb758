#pragma once

#include "report/report.hpp"

#include <string>
#include <vector>

namespace quell::examples {

/// What the page's scripts work on.
struct PageData {
    std::string json;                                        ///< all but the pictures, safe inside a script element
    std::vector<std::vector<unsigned char> const*> pictures; ///< the JSON refers to them by index; they stay the report's
};

PageData page_data(Report const& report);

} // namespace quell::examples
