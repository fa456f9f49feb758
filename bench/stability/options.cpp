#include "options.hpp"

#include <quell/core/error.hpp>
#include <support/program.hpp>
#include <support/size_in.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>

namespace quell::stability {
namespace {

void describe(CLI::App& app, StabilityOptions& options) {
    app.add_option("--case,--scene", options.cases, "A case that --list names, or all; may be given several times (default: all)")
        ->take_all();
    app.add_option("--out", options.out, "Folder for stability.csv, frames.csv and index.html")->capture_default_str();
    examples::add_threads(app, options.making.threads);
    app.add_option("--frames", options.making.long_run, "Frames of the case drift; the other cases are as long as what happens in them")
        ->check(CLI::Range(1200, 1000000))
        ->capture_default_str();
    app.add_option("--seed", options.making.seed, "Of the noise, in traced frames and in others")->capture_default_str();
    app.add_flag("--cheap", options.cheap, "Small pictures and rougher references: tests run it");
    app.add_flag("--check", options.check, "Exit code 1 where a promise is broken that isn't among the known limits");
    app.add_flag("--quiet", options.quiet, "No progress");
    app.add_flag("--list", options.list, "Print the names of the cases");
}

} // namespace

std::optional<StabilityOptions> stability_options(int argc, char const* const* argv) {
    CLI::App app("Tries every method where methods of its kind fail, over time, and compares what happens with what is promised.",
                 "quell-stability");
    StabilityOptions options;
    std::optional<std::string> size;
    std::optional<double> tolerance;
    describe(app, options);
    app.add_option("--size", size, "Width x height in pixels (default: 160x90; cheap: 96x54)");
    app.add_option("--tolerance", tolerance, "Of references: mean FLIP between two independent halves (default: 0.015; cheap: 0.03)")
        ->check(CLI::Range(0.001, 1.0));
    if (!examples::parse(app, argc, argv)) return std::nullopt;
    options.making.size = examples::size_in(size.value_or(options.cheap ? "96x54" : "160x90"), 16, 1LL << 24);
    options.making.tolerance = tolerance.value_or(options.cheap ? 0.03 : 0.015);
    if (options.cheap) options.making.max_samples = 64, options.making.broken_frames = 100;
    if (std::ranges::find(options.cases, "all") != options.cases.end()) options.cases.clear();
    return options;
}

} // namespace quell::stability
