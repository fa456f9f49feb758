#pragma once

#include <quell/image/extent.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace quell::examples {

/// What the command line of quell-demo says.
struct DemoOptions {
    std::vector<std::string> scenes{"room"};
    std::filesystem::path out = "out/demo";
    Extent size{480, 270};
    int frames = 33;
    int threads = 0; ///< 0: all
    std::uint32_t seed = 1;
    int reference_every = 16;          ///< every so many frames one is compared with a converged reference; 0: none
    double reference_tolerance = 0.02; ///< mean FLIP between the reference's two independent halves
    bool quiet = false, list = false;
};

/// Traces, denoises, scores and reports one scene into a folder. Returns the report's path.
/// @throws Error for a scene or a folder that can't be used
std::filesystem::path run_demo(DemoOptions const& options, std::string const& scene, std::filesystem::path const& folder);

} // namespace quell::examples
