#include <gauntlet/options.hpp>

#include <support/program.hpp>
#include <support/size_in.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>

namespace quell::gauntlet {

namespace {

void describe(CLI::App& app, GauntletOptions& options) {
    app.add_option("--scene,--situation", options.names, "A situation that --list names, or all; may be given several times (default: all)")
        ->take_all();
    app.add_option(
           "--sequence", options.sequences,
           "A folder SCENE/SAMPLES of frame_0001.exr and so on, whose references lie in SCENE/reference, in place of the situations; may "
           "be given several times")
        ->take_all();
    app.add_option("--samples", options.samples, "Of a pixel: any of 1, 4, 16, 64 (default: those of each situation)")
        ->delimiter(',')
        ->check(CLI::Range(1, 4096));
    app.add_option("--frames", options.making.frames, "Frames of each sequence")->check(CLI::Range(1, 1000))->capture_default_str();
    app.add_option("--seed", options.making.seed, "Of the noise")->capture_default_str();
    app.add_option("--out", options.out, "Folder for gauntlet.csv, frames.csv and index.html")->capture_default_str();
    app.add_option("--denoise", options.denoise, "The program quell-denoise")->capture_default_str();
    app.add_option("--stored", options.stored, "Figures of the program that this one is held against")->capture_default_str();
    app.add_option("--store", options.store, "Write the figures of this program to a file, for others to be held against");
    examples::add_threads(app, options.threads);
    app.add_flag("--smallest", options.smallest, "A few situations at 4 samples: tests run it");
    app.add_flag("--check", options.check, "Exit code 1 where a limit is broken");
    app.add_flag("--keep", options.keep, "Keep the frames, in the folder of --out");
    app.add_flag("--quiet", options.quiet, "No progress");
    app.add_flag("--list", options.list, "Print the names of the situations");
}

} // namespace

std::optional<GauntletOptions> gauntlet_options(int argc, char const* const* argv) {
    CLI::App app(
        "Denoises small sequences, in each of which one assumption does not hold, and compares what comes out with the input, with "
        "quell-denoise --quick and with the figures of an earlier program.",
        "quell-gauntlet");
    GauntletOptions options;
    options.denoise = QUELL_DENOISE, options.stored = QUELL_GAUNTLET_STORED;
    std::string size = "96x54";
    describe(app, options);
    app.add_option("--size", size, "Width x height in pixels")->capture_default_str();
    if (!examples::parse(app, argc, argv)) return std::nullopt;
    options.making.size = examples::size_in(size, 16, 1LL << 22);
    if (std::ranges::find(options.names, "all") != options.names.end()) options.names.clear();
    return options;
}

} // namespace quell::gauntlet
