#pragma once

#include <filesystem>
#include <string>

namespace quell::examples {

/// Whether gnuplot can be run.
[[nodiscard]] bool has_gnuplot();

/// Text between double quotes, of which gnuplot takes nothing for its own.
[[nodiscard]] std::string quoted_for_gnuplot(std::string const& text);

/// Writes a script, which names its pictures from its own folder, and lets gnuplot draw them.
/// @throws Error where it can't
void draw_by_gnuplot(std::filesystem::path const& script, std::string const& text);

} // namespace quell::examples
