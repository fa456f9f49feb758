#include "options.hpp"

#include "judge.hpp"

#include <denoise/presets.hpp>
#include <quell/core/error.hpp>
#include <support/program.hpp>
#include <support/size_in.hpp>
#include <tracer/scenes/scenes.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <set>
#include <thread>

namespace quell::bench {
namespace {

/// What the command line has in words.
struct Words {
    std::vector<std::string> scenes{"all"}, effects, externals, ins, references;
    std::string size;
};

void describe(CLI::App& app, ChartOptions& o, Words& words) {
    words.size = to_string(o.size);
    app.add_option("--scene", words.scenes,
                   "built-in scene or file.gltf, file.glb; repeatable; 'all' for every built-in one (default: all)");
    app.add_option("--effect", words.effects,
                   "shadow, glossy, curved, indirect, blur or composite; repeatable (default: what the scene was made for)")
        ->delimiter(',');
    app.add_option("--in", words.ins,
                   "noisy frames of any renderer in place of a scene, e.g. 'dir/frame.%04d.exr': charts those presets of quell-denoise "
                   "whose channels they have; repeatable");
    app.add_option("--reference", words.references, "converged frames of some of their numbers; one for each --in, in their order");
    app.add_option("--map", o.map, "JSON file that names the channels of --in, see quell-denoise --help");
    app.add_option("--first", o.first, "number of the first frame of --in (default: the first that there is)");
    app.add_option("--last", o.last, "number of the last frame of --in (default: the last that there is)");
    app.add_option("--out", o.out, "folder for chart.csv, index.html and pictures")->capture_default_str();
    app.add_option("--size", words.size, "width x height in pixels")->capture_default_str();
    app.add_option("--frames", o.frames, "number of frames; 24, 28, 31 to 34, 36 and 40 are scored")
        ->check(CLI::Range(ChartOptions::first_timed + 1, 100000))
        ->capture_default_str();
    app.add_option("--device", o.device, "what denoises --in: cpu, or cuda, an NVIDIA GPU, where this program was built for it")
        ->capture_default_str();
    examples::add_threads(app, o.threads);
    app.add_option("--seed", o.seed, "of the noise")->capture_default_str();
    app.add_option("--tolerance", o.tolerance,
                   "of the references: mean FLIP between two independent halves (default: 0.01; 0.005 for blur, 0.03 with indirect light)")
        ->check(CLI::Range(0.0001, 1.0));
    app.add_flag("--few", o.few, "score frames 24, 32 and 40 only");
    app.add_flag("--times", o.times, "score no frame, which takes no references: only milliseconds and bytes, from frame 8 on");
    app.add_option("--external", words.externals,
                   "'name=command {in} {out}': chart a program too; it gets patterns such as dir/frame.%04d.exr in place of {in} and "
                   "{out}; repeatable");
    app.add_flag("--quiet", o.quiet, "print nothing but errors");
    app.add_flag("--list", o.list, "print the built-in scenes, one a line");
}

External external_in(std::string const& text) {
    auto const equals = text.find('=');
    bool const whole =
        equals != std::string::npos && equals > 0 && text.find("{in}") != std::string::npos && text.find("{out}") != std::string::npos;
    if (!whole) throw Error("--external", "'" + text + "'", "write name=command with {in} and {out} in the command");
    External external{text.substr(0, equals), text.substr(equals + 1)};
    auto const plain = [](unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '_' || c == '.'; };
    if (!std::ranges::all_of(external.name, plain) || external.name.starts_with('.'))
        throw Error("--external", "the name '" + external.name + "'",
                    "use letters, digits, '-', '_' and '.' only, and no '.' at the start");
    if (external.name == Judge::reference_name)
        throw Error("--external", "the name '" + external.name + "'", "choose another: the reference has it");
    return external;
}

void check_names_differ(std::vector<External> const& externals) {
    std::set<std::string> names;
    for (auto const& external : externals)
        if (!names.insert(external.name).second)
            throw Error("--external", "two are called '" + external.name + "'", "give each a name of its own");
}

/// Scenes and files are not charted together: nothing that the one is asked for means anything to the other.
void check_files_or_scenes(CLI::App const& app) {
    auto const check_none = [&](std::initializer_list<char const*> options, std::string const& found, std::string const& remedy) {
        for (auto const* option : options)
            if (app.count(option) > 0) throw Error(option, found, remedy);
    };
    if (app.count("--in") == 0)
        return check_none({"--reference", "--map", "--first", "--last", "--device"}, "there is no --in",
                          "give the noisy frames, or leave it out");
    check_none({"--scene", "--effect", "--size", "--frames", "--seed", "--tolerance", "--few", "--times", "--external"},
               "it is for scenes, and --in is for files", "chart the one without the other");
}

std::vector<Files> files_of(Words const& words) {
    if (words.ins.size() != words.references.size())
        throw Error("--reference",
                    "there are " + std::to_string(words.references.size()) + " for " + std::to_string(words.ins.size()) + " of --in",
                    "give one for each, in their order");
    std::vector<Files> files;
    for (std::size_t i = 0; i < words.ins.size(); ++i) files.push_back({words.ins[i], words.references[i]});
    return files;
}

} // namespace

std::vector<int> ChartOptions::scored_frames() const {
    if (times) return {};
    std::vector<int> numbers = few ? std::vector{24, 32, 40} : std::vector{24, 28, 31, 32, 33, 34, 36, 40};
    std::erase_if(numbers, [&](int number) { return number >= frames; });
    return numbers;
}

bool ChartOptions::scores(int frame) const {
    auto const numbers = scored_frames();
    return std::ranges::find(numbers, frame) != numbers.end();
}

int ChartOptions::pictured_frame() const { return frames > pictured ? pictured : first_scored; }

ChartOptions chart_options(int argc, char const* const* argv) {
    ChartOptions options;
    Words words;
    CLI::App app("Speed against accuracy: every method on every scene that has its effect.", "quell-chart");
    describe(app, options, words);
    options.wants_help = !examples::parse(app, argc, argv);
    if (options.wants_help) return options;
    options.size = examples::size_in(words.size);
    if (!options.times && options.frames <= ChartOptions::first_scored)
        throw Error("--frames", std::to_string(options.frames) + ", of which none is scored", "give more than 24, or --times too");
    examples::check_device(options.device);
    check_files_or_scenes(app);
    options.files = files_of(words);
    if (options.files.empty()) options.cases = cases_of(words.scenes, words.effects);
    for (auto const& text : words.externals) options.externals.push_back(external_in(text));
    check_names_differ(options.externals);
    if (options.threads == 0) options.threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    return options;
}

} // namespace quell::bench
