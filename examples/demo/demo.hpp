#pragma once

#include "options.hpp"

namespace quell::examples {

/// Traces, denoises, scores and reports one scene into a folder. Returns the report's path.
/// @throws Error for a scene or a folder that can't be used
std::filesystem::path run_demo(DemoOptions const& options, std::string const& scene, std::filesystem::path const& folder);

} // namespace quell::examples
