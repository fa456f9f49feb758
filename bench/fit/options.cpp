#include "options.hpp"

#include <quell/core/error.hpp>
#include <support/program.hpp>
#include <support/size_in.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <thread>

namespace quell::bench {
namespace {

constexpr auto footer = R"(
Each effect (shadow, glossy, indirect) is either denoised by itself or left in the rest of the picture, which is denoised as one colour.
The smallest composition is the one that splits off the fewest effects, and of those the cheapest. With --ms alone, it is the smallest of
those in time whose error is within 2% of the least. Where the shutter is open, motion blur is made of the whole picture, and nothing is
split off.

Exit codes: 0 done, 1 no composition keeps to the bounds (the best one is named) or anything else, 2 unusable arguments or input.)";

void describe(CLI::App& app, FitOptions& o, std::string& size) {
    app.add_option("--scene", o.scene, "Built-in scene or file.gltf, file.glb");
    app.add_option("--in", o.in, "Or noisy frames, as of quell-trace --effects composite,shadow,glossy,indirect: 'dir/frame.%04d.exr'");
    app.add_option("--reference", o.reference, "Converged frames for these: 'dir/reference.%04d.exr'; frames that have one are scored");
    app.add_option("--map", o.map, "JSON file that names the channels of another renderer, see quell-denoise --help");
    app.add_option("--rmse", o.bounds.rmse, "Most root mean square error of the displayed picture, mean over the scored frames");
    app.add_option("--flip", o.bounds.flip, "Most FLIP");
    app.add_option("--ms", o.bounds.ms, "Most milliseconds per frame, at this size and number of threads");
    app.add_option("--out", o.out, "Header to write, as fit.hpp; its folder is made (default: none)");
    app.add_option("--size", size, "Width x height of a scene's frames (default: " + to_string(o.size) + ")");
    app.add_option("--frames", o.frames, "Frames of a scene; 24, 32 and 40 are scored (default: " + std::to_string(o.frames) + ")");
    examples::add_threads(app, o.threads);
    app.add_option("--seed", o.seed, "Of a scene's noise (default: 0)");
    app.add_option("--tolerance", o.tolerance, "Of a scene's references: mean FLIP between two independent halves (default: 0.02)");
    app.add_flag("--blur", o.blur, "Of a scene: the shutter is open for half of the frame time, and each sample has a time of its own");
    app.add_flag("--quiet", o.quiet, "Print nothing but errors");
    app.add_flag("--list", o.list, "Print the built-in scenes, one a line");
    app.footer(footer);
}

[[noreturn]] void refuse(std::string const& option, std::string const& found, std::string const& remedy) {
    throw Error(option, found, remedy);
}

void check_bound(char const* option, std::optional<double> const& bound) {
    if (bound && !(*bound > 0)) refuse(option, std::to_string(*bound), "give more than 0");
}

void check_source(FitOptions const& o, bool has_size) {
    if (o.scene.empty() == o.in.empty())
        refuse("command line", o.scene.empty() ? "neither --scene nor --in is there" : "--scene and --in are both there",
               "give one of them");
    if (!o.scene.empty()) return;
    if (o.reference.empty())
        refuse("command line", "--reference is missing", "say where the converged frames are, as in --reference 'dir/reference.%04d.exr'");
    if (o.blur) refuse("--blur", "frames from files have their own times", "leave it out");
    if (has_size) refuse("--size", "frames from files have their own", "leave it out");
}

void check(FitOptions const& o, bool has_size) {
    check_source(o, has_size);
    if (!o.bounds.asks_for_error() && !o.bounds.ms) refuse("command line", "no bound is there", "give --rmse, --flip or --ms");
    check_bound("--rmse", o.bounds.rmse), check_bound("--flip", o.bounds.flip), check_bound("--ms", o.bounds.ms);
    check_bound("--tolerance", o.tolerance);
    if (o.frames < 25) refuse("--frames", std::to_string(o.frames), "give at least 25: frame 24 is the first that is scored");
}

} // namespace

FitOptions fit_options(int argc, char const* const* argv) {
    FitOptions options;
    std::string size;
    CLI::App app("Finds the smallest composition of pipelines that keeps a sequence to a bound, and writes it as a header.", "quell-fit");
    describe(app, options, size);
    options.wants_help = !examples::parse(app, argc, argv);
    if (options.wants_help || options.list) return options;
    check(options, !size.empty());
    if (!size.empty()) options.size = examples::size_in(size);
    if (options.threads == 0) options.threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    return options;
}

} // namespace quell::bench
