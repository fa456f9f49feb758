#include "demo.hpp"

#include <support/output_folder.hpp>
#include <support/program.hpp>
#include <support/size_in.hpp>
#include <tracer/scenes/scenes.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>

namespace {

using namespace quell;

void run(int argc, char const* const* argv) {
    examples::DemoOptions options;
    std::string size = to_string(options.size);
    CLI::App app("Traces a scene at one sample per pixel, denoises it, and writes EXR, PNG and an HTML report.", "quell-demo");
    app.add_option("--scene", options.scenes, "built-in scene or file.gltf, file.glb; repeatable; 'all' for every built-in one")
        ->capture_default_str();
    app.add_option("--out", options.out, "folder for the results")->capture_default_str();
    app.add_option("--size", size, "width x height in pixels")->capture_default_str();
    app.add_option("--frames", options.frames, "number of frames")->check(CLI::Range(1, 100000))->capture_default_str();
    examples::add_threads(app, options.threads);
    app.add_option("--seed", options.seed, "of the noise")->capture_default_str();
    app.add_option("--reference-every", options.reference_every, "compare every so many frames with a converged reference; 0: none")
        ->check(CLI::Range(0, 100000))
        ->capture_default_str();
    app.add_option("--reference-tolerance", options.reference_tolerance, "mean FLIP between the reference's independent halves")
        ->check(CLI::Range(0.001, 1.0))
        ->capture_default_str();
    app.add_flag("--quiet", options.quiet, "no progress");
    app.add_flag("--list", options.list, "print the built-in scenes, one a line");
    if (!examples::parse(app, argc, argv)) return;
    if (options.list) {
        for (auto const& name : tracer::scene_names()) std::puts(name.c_str());
        return;
    }
    options.size = examples::size_in(size);
    if (std::ranges::find(options.scenes, "all") != options.scenes.end()) options.scenes = tracer::scene_names();
    auto const folders = examples::folders_of_scenes(options.out, options.scenes);
    for (std::size_t i = 0; i < folders.size(); ++i) {
        auto const page = examples::run_demo(options, options.scenes[i], folders[i]);
        std::printf("%s\n", std::filesystem::absolute(page).string().c_str());
    }
}

} // namespace

int main(int argc, char const* const* argv) {
    return examples::exit_code_of("quell-demo", [&] { run(argc, argv); });
}
