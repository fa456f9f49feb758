#include "options.hpp"

#include <quell/core/error.hpp>
#include <support/program.hpp>
#include <support/size_in.hpp>
#include <tracer/scenes/scenes.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>

namespace quell::examples {

DemoOptions demo_options(int argc, char const* const* argv) {
    DemoOptions options;
    std::string size = to_string(options.size);
    CLI::App app("Traces a scene at one sample per pixel, denoises it, and writes EXR, PNG and an HTML report.", "quell-demo");
    app.add_option("--scene", options.scenes, "built-in scene or file.gltf, file.glb; repeatable; 'all' for every built-in one")
        ->capture_default_str();
    app.add_option("--out", options.out, "folder for the results")->capture_default_str();
    app.add_option("--size", size, "width x height in pixels")->capture_default_str();
    app.add_option("--frames", options.frames, "number of frames")->check(CLI::Range(1, 100000))->capture_default_str();
    add_threads(app, options.threads);
    app.add_option("--seed", options.seed, "of the noise")->capture_default_str();
    app.add_option("--reference-every", options.reference_every, "compare every so many frames with a converged reference; 0: none")
        ->check(CLI::Range(0, 100000))
        ->capture_default_str();
    app.add_option("--reference-tolerance", options.reference_tolerance, "mean FLIP between the reference's independent halves")
        ->check(CLI::Range(0.001, 1.0))
        ->capture_default_str();
    app.add_flag("--quiet", options.quiet, "no progress");
    app.add_flag("--list", options.list, "print the built-in scenes, one a line");
    options.wants_help = !parse(app, argc, argv);
    options.size = size_in(size);
    if (std::find(options.scenes.begin(), options.scenes.end(), "all") != options.scenes.end()) options.scenes = tracer::scene_names();
    return options;
}

} // namespace quell::examples
