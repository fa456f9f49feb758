#pragma once

#include "results.hpp"

#include <filesystem>

namespace quell::stability {

/// Writes index.html: the error over time of each case, every promise, and why some don't hold.
void write_page(Results const& results, std::filesystem::path const& folder);

} // namespace quell::stability
