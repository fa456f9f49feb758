#include <denoise/composite.hpp>
#include <denoise/debug_view.hpp>
#include <denoise/map_file.hpp>
#include <denoise/options.hpp>
#include <denoise/presets.hpp>
#include <denoise/scores.hpp>
#include <denoise/sequence_denoiser.hpp>
#include <support/frame_pattern.hpp>
#include <support/output_folder.hpp>
#include <support/program.hpp>
#include <support/progress.hpp>

#include <quell/io/write_exr.hpp>

#include <cstdio>
#include <iostream>

using namespace quell;
using namespace quell::examples;

namespace {

struct Range : FrameRange {
    long long begin; ///< from here on frames are denoised, from first on they are written
};

Range range_of(DenoiseOptions const& options, FramePattern const& in) {
    auto const range = examples::range_of(in, options.first, options.last);
    // A shot's first frames have none before them to warm up with.
    return {range, std::max(range.first - options.warmup, std::min(range.first, in.on_disk().front()))};
}

/// Where the results go.
class Output {
    std::optional<FramePattern> pattern;

public:
    Output(DenoiseOptions const& options, FramePattern const& in, Range const& range) {
        if (options.out.empty()) return;
        pattern.emplace(options.out);
        auto const written = in.on_disk(range.first, range.last);
        check_keeps(in, "the input's own files", *pattern, written);
        if (!options.reference.empty()) check_keeps(FramePattern(options.reference), "the references", *pattern, written);
        auto const folder = pattern->path(range.first).parent_path();
        make_output_folder(folder.empty() ? "." : folder);
    }

    void write(long long number, metrics::Picture const& picture) const {
        if (!pattern) return;
        io::ExrImage image{.name = pattern->path(number).string(), .size = picture.size};
        for (int c = 0; auto const* const name : {"R", "G", "B"}) {
            io::Plane plane{.name = name, .type = io::SampleType::half, .values = {}};
            for (auto const& pixel : picture.pixels) plane.values.push_back(pixel[c]);
            image.planes.push_back(std::move(plane));
            ++c;
        }
        store([&] { io::write_exr(image.name, image); });
    }

    void write_views(long long number, std::string const& view, std::vector<std::pair<std::string, DebugImage>> const& images) const {
        for (auto const& each : images) store([&] { write_debug_view(pattern->path(number), view, each.first, each.second); });
    }
};

/// The references that there are, and the table.
class Comparison {
    std::optional<FramePattern> pattern;
    std::optional<Scores> scores;

public:
    Comparison(std::string const& reference, Range const& range) {
        if (reference.empty()) return;
        pattern.emplace(reference);
        static_cast<void>(numbers_of_references(*pattern, range)); // there is at least one
        scores.emplace(std::cout);
    }

    void add(long long number, metrics::Picture const& picture, std::optional<io::SequenceNames> const& map) {
        if (!pattern || !std::filesystem::exists(pattern->path(number))) return;
        scores->add(number, read_reference(pattern->path(number), map, picture.size), picture);
    }
    void finish() const {
        if (scores) scores->finish();
    }
};

/// What suits the files, where no preset was asked for.
PresetChoice suitable_preset(std::filesystem::path const& first, std::optional<io::SequenceNames> const& map) {
    io::ExrFile const file(first);
    return preset_for(file, map ? *map : io::recognise(file));
}

int later_frames(DenoiseOptions const& options, Preset const& preset) {
    if (options.extra_frames.value_or(0) > 0 && !preset.looks_ahead)
        throw Error("--extra-frames", "preset " + preset.name + " makes no use of later frames",
                    "leave it out, or take --preset final-frame");
    if (options.extra_frames.value_or(0) > 0 && !options.debug_views.empty())
        throw Error("--extra-frames", "--debug-view shows what happens without later frames", "leave one of the two out");
    return options.extra_frames.value_or(preset.looks_ahead ? Preset::usual_later_frames : 0);
}

void print_plan(DenoiseOptions const& options) {
    auto const choose = [&] {
        if (!options.preset.empty()) return &preset_of(options.preset);
        FramePattern const in(options.in);
        std::optional<io::SequenceNames> map;
        if (!options.map.empty()) map = read_map(options.map);
        return suitable_preset(in.path(range_of(options, in).begin), map).preset;
    };
    auto const& preset = *choose();
    std::cout << preset.name << "\n\n" << preset.make({1, 1}, 1)->plan();
}

void denoise(DenoiseOptions const& options) {
    PresetChoice choice;
    if (!options.preset.empty()) choice.preset = &preset_of(options.preset);
    FramePattern const in(options.in);
    auto const range = range_of(options, in);
    std::optional<io::SequenceNames> map;
    if (!options.map.empty()) map = read_map(options.map);
    if (!choice.preset) choice = suitable_preset(in.path(range.begin), map);
    auto const& preset = *choice.preset;
    Output const output(options, in, range);
    Comparison comparison(options.reference, range);
    SequenceDenoiser denoiser({.preset = preset,
                               .threads = options.threads,
                               .map = map,
                               .shutter = options.shutter,
                               .later_frames = later_frames(options, preset),
                               .diagnose = options.diagnose,
                               .debug_views = options.debug_views});
    int findings = 0;
    {
        Progress progress(preset.name, range.last - range.begin + 1, !options.quiet);
        for (auto number = range.begin; number <= range.last; ++number) {
            progress.show(number - range.begin, in.path(number).filename().string());
            auto const picture = denoiser.next(in, number);
            for (auto const& finding : denoiser.findings())
                progress.say("quell-denoise: frame " + std::to_string(number) + ": " + to_string(finding)), ++findings;
            if (number < range.first) continue;
            output.write(number, picture);
            for (auto const& view : options.debug_views) output.write_views(number, view, denoiser.debug_images(view));
            comparison.add(number, picture, map);
        }
    }
    comparison.finish();
    if (options.quiet) return;
    if (options.diagnose && findings == 0) std::fprintf(stderr, "quell-denoise: --diagnose found nothing wrong\n");
    if (!choice.reason.empty()) std::fprintf(stderr, "quell-denoise: preset %s, since %s\n", preset.name.c_str(), choice.reason.c_str());
    for (auto const& remark : denoiser.names()->remarks) std::fprintf(stderr, "quell-denoise: %s\n", remark.c_str());
    auto const frames = range.last - range.first + 1, missing = denoiser.missing_samples();
    auto const files = map ? in.text() : denoiser.names()->renderer;
    std::fprintf(stderr, "quell-denoise: %lld %s of %s; %lld %s missing (not finite, or negative)\n", frames,
                 frames == 1 ? "frame" : "frames", files.c_str(), missing, missing == 1 ? "sample was" : "samples were");
}

} // namespace

#if defined(QUELL_DENOISE_ENTRY) // one of several instruction sets: dispatch.cpp.in calls it
extern "C" int QUELL_DENOISE_ENTRY(int argc, char** argv);
extern "C" int QUELL_DENOISE_ENTRY(int argc, char** argv) {
#else
int main(int argc, char** argv) {
#endif
    auto const body = [&] {
        auto const options = denoise_options(argc, argv);
        if (!options) return;
        if (options->plan) return print_plan(*options);
        if (!options->list) return denoise(*options);
        for (auto const& preset : presets()) std::cout << preset.name << '\n';
    };
    return exit_code_of("quell-denoise", body, "choose a --preset that takes less (--plan says how much), or give --extra-frames 0");
}
