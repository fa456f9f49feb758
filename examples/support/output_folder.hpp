#pragma once

#include <filesystem>

namespace quell::examples {

/// Makes the folder that --out names, and makes sure that files can be written there before the work for them begins.
/// @throws Error where they can't
void make_output_folder(std::filesystem::path const& folder);

/// The same for the folder of a file that --out names.
void make_folder_for(std::filesystem::path const& file);

} // namespace quell::examples
