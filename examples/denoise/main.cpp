#include <denoise/composite.hpp>
#include <denoise/frame_list.hpp>
#include <denoise/map_file.hpp>
#include <denoise/options.hpp>
#include <denoise/output.hpp>
#include <denoise/presets.hpp>
#include <denoise/renderer_maps.hpp>
#include <denoise/scores.hpp>
#include <denoise/sequence_denoiser.hpp>
#include <denoise/signal_choice.hpp>
#include <denoise/summary.hpp>
#include <support/frame_pattern.hpp>
#include <support/program.hpp>
#include <support/progress.hpp>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <sstream>

using namespace quell;
using namespace quell::examples;

namespace {

/// The references that there are, and the table.
class Comparison {
    std::optional<FramePattern> pattern;
    std::ostringstream nowhere;
    std::optional<Scores> scores;

public:
    Comparison(DenoiseOptions const& options, std::vector<long long> const& frames) {
        if (options.reference.empty()) return;
        pattern.emplace(options.reference);
        // There must be at least one.
        auto const with_reference = numbers_of_references(*pattern, {frames.front(), frames.back()});
        if (std::ranges::none_of(frames, [&](auto number) { return std::ranges::binary_search(with_reference, number); }))
            throw Error(pattern->text(), "there is none for these frames", "give converged frames with the numbers of the noisy ones");
        scores.emplace(options.json ? static_cast<std::ostream&>(nowhere) : std::cout);
    }

    void add(long long number, metrics::Picture const& picture, ReferenceNames const& names, Summary& summary) {
        if (!pattern || !std::filesystem::exists(pattern->path(number))) return;
        summary.scores.emplace_back(number, scores->add(number, read_reference(pattern->path(number), names, picture.size), picture));
    }
    void finish() const {
        if (scores) scores->finish();
    }
};

/// The signal that is asked for.
std::optional<SignalChoice> signal_in(std::filesystem::path const& first, std::optional<io::SequenceNames> const& names,
                                      std::string const& word) {
    if (word.empty()) return std::nullopt;
    io::ExrFile const file(first);
    return choose_signal(word, file, names ? *names : recognised(file));
}

/// What suits the files, where no preset was asked for.
PresetChoice suitable_preset(std::filesystem::path const& first, std::optional<io::SequenceNames> const& map,
                             std::optional<SignalChoice> const& signal) {
    io::ExrFile const file(first);
    return signal ? preset_for(file, *signal) : preset_for(file, map ? *map : recognised(file));
}

/// How references hold what a preset makes: the effect's part of the picture, or the picture.
ReferenceNames reference_names(Preset const& preset, std::optional<io::SequenceNames> const& map) {
    auto const picture = map ? *map : io::own_sequence();
    auto const effects = names_of_effects(preset, picture);
    if (!effects) return map;
    if (preset.is_part) return {{*effects, picture}, true};
    return {{picture, *effects}, true};
}

int later_frames(DenoiseOptions const& options, Preset const& preset) {
    if (options.extra_frames.value_or(0) > 0 && !preset.looks_ahead)
        throw Error("--extra-frames", "preset " + preset.name + " makes no use of later frames",
                    "leave it out, or take --preset final-frame");
    if (options.extra_frames.value_or(0) > 0 && !options.debug_views.empty())
        throw Error("--extra-frames", "--debug-view shows what happens without later frames", "leave one of the two out");
    return options.extra_frames.value_or(preset.looks_ahead ? Preset::usual_later_frames : 0);
}

/// All frames that the command line asks for, in whichever chunk, on disk or not.
std::vector<long long> all_frames(DenoiseOptions const& options, FramePattern const& in) {
    auto const range = range_of(in, options.first, options.last);
    if (!options.frames.empty()) return frames_in(options.frames);
    std::vector<long long> frames;
    for (auto number = range.first; number <= range.last; ++number) frames.push_back(number);
    return frames;
}

/// What the first of all frames is recognised as, so that all chunks go by the same; nothing where it can't be read.
std::optional<io::SequenceNames> names_in(std::filesystem::path const& first) {
    if (!std::filesystem::exists(first)) return std::nullopt;
    try {
        return recognised(io::ExrFile(first));
    } catch (Error const&) {
        return std::nullopt; // another chunk complains of it
    }
}

void print_plan(DenoiseOptions const& options) {
    auto const choose = [&] {
        if (!options.preset.empty()) return &preset_of(options.preset);
        FramePattern const in(options.in);
        std::optional<io::SequenceNames> map;
        auto const first = in.path(range_of(in, options.first, options.last).first);
        if (!options.map.empty()) map = read_map(options.map, {first});
        return suitable_preset(first, map, signal_in(first, map, options.signal)).preset;
    };
    auto const& preset = *choose();
    std::cout << preset.name << "\n\n" << preset.make({1, 1}, 1)->plan();
}

/// One run over a sequence. Everything that can be refused is, before the first frame.
class Job {
    DenoiseOptions const& options;
    FramePattern const in;
    std::vector<long long> frames;
    std::optional<io::SequenceNames> map, names; ///< that the user gave; that the files are read by, where these are known already
    ReferenceNames references;
    PresetChoice choice;
    Summary& summary;
    std::optional<Output> output;
    std::vector<long long> wanted; ///< frames that are to be written
    std::optional<Comparison> comparison;
    std::optional<SequenceDenoiser> denoiser;

public:
    Job(DenoiseOptions const& o, Summary& s) : options(o), in(o.in), frames(all_frames(o, in)), summary(s) {
        auto const first = in.path(frames.front());
        if (!options.chunk.empty()) frames = part_of(frames, chunk_in(options.chunk));
        if (!options.map.empty()) map = read_map(options.map, {first, frames.empty() ? first : in.path(frames.front())});
        names = map ? map : names_in(first);
        if (!options.preset.empty()) choice.preset = &preset_of(options.preset);
        output.emplace(options, in, frames);
        for (auto const number : frames) (options.skip_existing && output->has(number) ? summary.skipped : wanted).push_back(number);
        if (wanted.empty()) return;
        auto const signal = signal_in(in.path(wanted.front()), names, options.signal);
        if (!choice.preset) choice = suitable_preset(in.path(wanted.front()), names, signal);
        if (signal) names = names_for(*choice.preset, *signal);
        references = signal ? ReferenceNames{{*names}, false} : reference_names(*choice.preset, map);
        summary.preset = choice.preset->name, summary.preset_reason = choice.reason, summary.signal = options.signal;
        if (!options.layers.empty()) output->check(wanted.front(), names);
        if (names) output->check_levels(wanted.front(), *names);
        comparison.emplace(options, wanted);
        denoiser.emplace(SequenceSettings{.preset = *choice.preset,
                                          .threads = options.threads,
                                          .map = names,
                                          .shutter = options.shutter,
                                          .field_of_view = options.field_of_view,
                                          .later_frames = later_frames(options, *choice.preset),
                                          .keeps_alpha = options.keep_alpha,
                                          .diagnose = options.diagnose,
                                          .debug_views = options.debug_views});
    }

    void run() {
        if (wanted.empty()) return;
        WarmUp const warm_up{options.warmup ? *options.warmup : choice.preset->warm_up, !options.warmup};
        auto const steps = steps_for(wanted, warm_up, in.on_disk());
        Progress progress(choice.preset->name, static_cast<long long>(steps.size()), !options.quiet);
        for (long long done = 0; auto const& step : steps) {
            progress.show(done++, in.path(step.number).filename().string());
            if (step.begins) denoiser->forget();
            if (step.is_written)
                write(step.number, progress);
            else
                warm_up_with(step.number, progress);
        }
        comparison->finish();
    }

    /// Adds what the denoiser knows, of a run that was stopped too.
    void finish() {
        if (output)
            for (auto const& remark : output->remarks()) summary.remarks.push_back(remark);
        if (!denoiser) return;
        summary.missing_samples = denoiser->missing_samples();
        summary.milliseconds = denoiser->milliseconds();
        summary.bytes_per_pixel = denoiser->bytes_per_pixel();
        if (!denoiser->names()) return;
        summary.renderer = map && map->renderer == options.map && !find_renderer_map(options.map) ? in.text() : denoiser->names()->renderer;
        summary.remarks.insert(summary.remarks.begin(), denoiser->names()->remarks.begin(), denoiser->names()->remarks.end());
        if (denoiser->left_alpha())
            summary.remarks.push_back("alpha is as in the files: preset " + choice.preset->name +
                                      " does not denoise it, general and final-frame do");
        if (auto const changes = denoiser->canvas_changes(); changes > 0)
            summary.remarks.push_back("history started afresh " + std::to_string(changes) +
                                      " times, where data windows began to reach farther out of the display window");
    }

private:
    void report_findings(long long number, Progress& progress) {
        for (auto const& finding : denoiser->findings()) {
            auto const text = "frame " + std::to_string(number) + ": " + to_string(finding);
            progress.say("quell-denoise: " + text);
            (finding.mistake == Mistake::not_checked ? summary.not_checked : summary.findings).push_back(text);
        }
    }
    /// Where nobody asked for these frames, a broken one is as good as none.
    void warm_up_with(long long number, Progress& progress) {
        try {
            static_cast<void>(denoiser->next_whole(in, number));
        } catch (Error const&) {
            if (options.warmup) throw;
            denoiser->forget();
        }
        ++summary.warm_up_frames;
        report_findings(number, progress);
    }
    void write(long long number, Progress& progress) {
        if (names) output->check_levels(number, *names);
        auto frame = denoiser->next_whole(in, number);
        report_findings(number, progress);
        auto const shown = denoiser->displayed(frame.picture);
        output->write(number, frame, *denoiser->names());
        for (auto const& view : options.debug_views) output->write_views(number, view, denoiser->debug_images(view));
        summary.written.push_back(number);
        comparison->add(number, shown, references, summary);
    }
};

void denoise(DenoiseOptions const& options) {
    Summary summary;
    try {
        Job job(options, summary);
        try {
            job.run();
        } catch (...) {
            job.finish();
            throw;
        }
        job.finish();
    } catch (std::exception const& error) {
        summary.error = error.what();
        if (options.json) std::cout << json_of(summary) << std::endl;
        throw;
    }
    if (options.json) std::cout << json_of(summary) << '\n';
    if (options.quiet) return;
    if (options.diagnose && summary.findings.empty()) std::fprintf(stderr, "quell-denoise: --diagnose found nothing wrong\n");
    say(summary);
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
