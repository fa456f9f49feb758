#pragma once

#include "gltf/gltf.hpp"
#include "render_settings.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace quell::tracer {

/// What the command line of quell-trace says.
struct TraceOptions {
    std::vector<std::string> scenes, effects;
    std::filesystem::path out;
    RenderSettings rendered; ///< but for the frame's number
    std::optional<float> shutter;
    CameraChoice camera;
    int frames = 48, first = 0;
    int reference = 0; ///< most samples per pixel of converged frames; 0: there are none
    bool masks = false, primary_only = false, quiet = false, list = false;

    [[nodiscard]] bool has(std::string const& effect) const;
};

/// Nothing where help was asked for, which has then been printed.
/// @throws Error for a command line that can't be used
[[nodiscard]] std::optional<TraceOptions> trace_options(int argc, char const* const* argv);

} // namespace quell::tracer
