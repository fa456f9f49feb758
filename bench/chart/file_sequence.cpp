#include "file_sequence.hpp"

#include "judge.hpp"

#include <denoise/composite.hpp>
#include <denoise/map_file.hpp>
#include <denoise/presets.hpp>
#include <denoise/sequence_denoiser.hpp>
#include <quell/core/error.hpp>
#include <support/median.hpp>

#include <algorithm>
#include <set>

namespace quell::bench {
namespace {

namespace fs = std::filesystem;
using examples::FramePattern;
using examples::Preset;

constexpr auto effect = "composite"; // renderers' files are of whole pictures

/// The last folders of a file's path, with '-' between them. Empty where it has not so many.
std::string folders_of(std::string const& in, int count) {
    auto folder = fs::absolute(in).lexically_normal().parent_path();
    std::string name;
    for (; count > 0 && folder.has_filename(); --count, folder = folder.parent_path())
        name = folder.filename().string() + (name.empty() ? "" : "-") + name;
    return count == 0 ? name : "";
}

/// As few folders as tell the sequences apart.
std::vector<std::string> scenes_of(std::vector<Files> const& files) {
    for (int count = 1;; ++count) {
        std::vector<std::string> names;
        for (auto const& one : files) names.push_back(folders_of(one.in, count));
        if (std::set<std::string>(names.begin(), names.end()).size() == names.size()) return names;
        if (std::ranges::find(names, "") != names.end())
            throw Error("--in", "two sequences lie in one folder", "chart them by themselves: each is called what its folder is");
    }
}

void check_no_gap(FramePattern const& in, examples::FrameRange const& range) {
    auto number = range.first;
    for (auto const there : in.on_disk(range.first, range.last))
        if (there == number) ++number;
    if (number > range.last) return;
    throw Error(in.path(number).string(), "it is missing", "give all frames, or those before or after it with --last or --first");
}

/// Those that make whole pictures of what the file has.
/// @param device what runs them; the input itself is there in any case
std::vector<FileMethod> methods_for(io::ExrFile const& file, io::SequenceNames const& names, std::string const& device) {
    auto const& on_device = examples::presets_on(device);
    std::vector<FileMethod> methods;
    for (auto const& preset : examples::presets()) {
        if (examples::is_part(preset) || preset.wants_sharp_picture) continue;
        // The input itself is always there: it complains by name of what it lacks.
        if (preset.name != "none" && !examples::applies(preset, file, names)) continue;
        if (device != "cpu" && preset.name != "none") {
            auto const found = std::ranges::find(on_device, preset.name, &examples::Preset::name);
            if (found != on_device.end()) methods.push_back({preset.name, *found});
            continue;
        }
        methods.push_back({preset.name, preset});
        if (examples::looks_ahead(preset)) methods.push_back({preset.name + "-two-sided", preset, examples::usual_later_frames});
    }
    return methods;
}

FileSequence file_sequence(ChartOptions const& options, Files const& files, std::string const& scene) {
    FramePattern const in(files.in), reference(files.reference);
    auto const range = examples::range_of(in, options.first, options.last);
    check_no_gap(in, range);
    io::ExrFile const first(in.path(range.first));
    std::optional<io::SequenceNames> map;
    if (!options.map.empty()) map = examples::read_map(options.map, &first);
    return {scene,      in,
            reference,  map,
            range,      examples::numbers_of_references(reference, range),
            first.size, methods_for(first, map ? *map : examples::recognised(first), options.device)};
}

std::vector<Wanted> wanted_of(FileSequence const& sequence) {
    std::vector<Wanted> all;
    for (auto const number : sequence.scored) {
        auto const picture = examples::read_reference(sequence.reference.path(number), sequence.map, sequence.size);
        all.push_back({number, metrics::displayed(picture), {}});
    }
    return all;
}

/// Denoises all frames with one method.
Row row_of(FileSequence const& sequence, FileMethod const& method, int threads, Judge const& judge,
           std::function<void(std::string const&)> const& progress) {
    examples::SequenceDenoiser denoiser(
        {.preset = method.preset, .threads = threads, .map = sequence.map, .shutter = {}, .later_frames = method.later_frames});
    Entry entry{method.name};
    std::vector<double> times;
    int const first_timed = std::min(ChartOptions::first_timed, sequence.frames() / 2);
    for (auto number = sequence.range.first; number <= sequence.range.last; ++number) {
        progress(method.name + " frame " + std::to_string(number));
        double const before = denoiser.milliseconds();
        auto const picture = denoiser.next(sequence.in, number);
        if (number - sequence.range.first >= first_timed) times.push_back(denoiser.milliseconds() - before);
        if (std::ranges::binary_search(sequence.scored, number)) judge.measure(number, std::span(&entry, 1), std::span(&picture, 1));
    }
    return judge.row_of(entry, examples::median(times), denoiser.bytes_per_pixel());
}

} // namespace

std::vector<FileSequence> file_sequences(ChartOptions const& options) {
    auto const scenes = scenes_of(options.files);
    std::vector<FileSequence> all;
    for (std::size_t i = 0; i < scenes.size(); ++i) all.push_back(file_sequence(options, options.files[i], scenes[i]));
    return all;
}

void chart_files(ChartOptions const& options, FileSequence const& sequence, std::function<void(std::string const& doing)> const& progress,
                 Results& results) {
    auto of_sequence = options;
    of_sequence.size = sequence.size, of_sequence.frames = sequence.frames();
    Judge const judge(of_sequence, {sequence.scene, effect}, wanted_of(sequence), sequence.scored.back());
    std::vector<Row> rows;
    for (auto const& method : sequence.methods) rows.push_back(row_of(sequence, method, options.threads, judge, progress));
    results.add(std::move(rows));
}

} // namespace quell::bench
