#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace quell::examples {

/// Makes the folder that --out names, and makes sure that files can be written there before the work for them begins.
/// @throws Error where they can't
void make_output_folder(std::filesystem::path const& folder);

/// The same for the folder of a file that --out names.
void make_folder_for(std::filesystem::path const& file);

/// Where the results of each scene go: to the folder itself if there is only one, else each to one of its own in there, of the scene's
/// name.
/// @throws Error where two scenes have the same
[[nodiscard]] std::vector<std::filesystem::path> folders_of_scenes(std::filesystem::path const& out,
                                                                   std::vector<std::string> const& scenes);

} // namespace quell::examples
