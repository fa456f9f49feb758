#include <denoise/frame_list.hpp>
#include <denoise/layers.hpp>
#include <denoise/layout_changes.hpp>
#include <denoise/options.hpp>
#include <denoise/output.hpp>
#include <denoise/presets.hpp>
#include <denoise/renderer_maps.hpp>
#include <denoise/scores.hpp>
#include <denoise/sequence_denoiser.hpp>
#include <denoise/sequence_views.hpp>
#include <denoise/stage_account.hpp>
#include <denoise/summary.hpp>
#include <library/name_list.hpp>
#include <library/stage.hpp>
#include <support/frame_pattern.hpp>
#include <support/program.hpp>
#include <support/progress.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <deque>
#include <iostream>
#include <set>
#include <sstream>
#if defined(__GLIBC__)
#include <malloc.h>
#endif

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

    [[nodiscard]] bool has(long long number) const { return pattern && std::filesystem::exists(pattern->path(number)); }
    /// Scores the first view, with a row of the table.
    void add(long long number, metrics::Picture const& picture, ReferenceNames const& names, FrameScores& rows) {
        if (!has(number)) return;
        rows.emplace_back(number, Scores::compare(reference(number, names, picture.size), picture));
        scores->add(number, rows.back().second);
    }
    /// Scores another view. Returns whether the reference has it.
    [[nodiscard]] bool add_beside(long long number, metrics::Picture const& picture, ReferenceNames const& names, FrameScores& rows) const {
        if (!has(number)) return true;
        try {
            rows.emplace_back(number, Scores::compare(reference(number, names, picture.size), picture));
            return true;
        } catch (Error const&) {
            return false;
        }
    }
    void finish() const {
        if (scores) scores->finish();
    }

private:
    [[nodiscard]] metrics::Picture reference(long long number, ReferenceNames const& names, Extent size) const {
        return read_reference(pattern->path(number), names, size);
    }
};

int later_frames(DenoiseOptions const& options, Preset const& preset) {
    if (options.extra_frames.value_or(0) > 0 && !looks_ahead(preset))
        throw Error("--extra-frames", "preset " + preset.name + " makes no use of later frames",
                    "leave it out, or take --preset final-frame");
    if (options.extra_frames.value_or(0) > 0 && !options.debug_views.empty())
        throw Error("--extra-frames", "--debug-view shows what happens without later frames", "leave one of the two out");
    return options.extra_frames.value_or(looks_ahead(preset) ? usual_later_frames : 0);
}

/// All frames that the command line asks for, in whichever chunk, on disk or not.
std::vector<long long> all_frames(DenoiseOptions const& options, FramePattern const& in) {
    auto const range = range_of(in, options.first, options.last);
    if (!options.frames.empty()) return frames_in(options.frames);
    std::vector<long long> frames;
    for (auto number = range.first; number <= range.last; ++number) frames.push_back(number);
    return frames;
}

/// What comes out behind a preset's passes.
void print_upsampling(DenoiseOptions const& options) {
    std::cout << fmt::format("\nupsampled behind these passes, {} times", *options.upsample);
    if (!options.in.empty()) {
        FramePattern const in(options.in);
        auto const size = io::ExrFile(in.path(all_frames(options, in).front())).size;
        std::cout << fmt::format(": {} from {}", to_string(Upsampling{*options.upsample}.enlarged(size)), to_string(size));
    }
    std::cout << '\n';
}

/// What is done behind a preset.
std::vector<std::string> stages_of(DenoiseOptions const& options, Preset const& preset) {
    if (options.quick) return {};
    if (!options.stages) return quell_library::names_in(preset.stages);
    auto const& wanted = *options.stages;
    if (!wanted.empty() && preset.usual.signal != radiance.name)
        throw Error("--stages", "preset " + preset.name + " does not denoise a picture by one history", "leave it out, or take general");
    return wanted;
}
bool has(std::vector<std::string> const& stages, std::string_view name) { return std::ranges::find(stages, name) != stages.end(); }

void print_plan(DenoiseOptions const& options) {
    auto const choose = [&] {
        if (!options.preset.empty()) return &preset_of(options.preset);
        FramePattern const in(options.in);
        auto const first = in.path(range_of(in, options.first, options.last).first);
        return SequenceViews(options.map, {first}).choose(nullptr, options.signal, first).preset;
    };
    auto const& preset = *choose();
    auto const& way = way_of(preset);
    std::cout << preset.name << "\n\n";
    auto const stages = stages_of(options, preset);
    if (has(stages, "evidence")) std::cout << quell_library::plan_of_choice(way, way_of(quell_library::judge_of(preset)));
    auto plan = way.plan();
    for (auto const& stage : quell_library::stages())
        if (is_own_stage(stage.name) && has(stages, stage.name)) plan = stage.plan(plan, way, way);
    std::cout << plan;
    if (has(stages, "light")) std::cout << plans_of_residual_links();
    if (options.upsample) print_upsampling(options);
}

/// One run over a sequence. Everything that can be refused is, before the first frame.
class Job {
    DenoiseOptions const& options;
    FramePattern const in;
    std::vector<long long> frames;
    std::optional<SequenceViews> views;
    std::optional<Upsampling> upsampling;
    PresetChoice choice;
    Summary& summary;
    std::optional<Output> output;
    std::vector<long long> wanted; ///< frames that are to be written
    std::optional<Comparison> comparison;
    std::deque<SequenceDenoiser> denoisers;  ///< one for each view
    std::set<std::string> without_reference; ///< names of views
    StageTotals stages;

public:
    Job(DenoiseOptions const& o, Summary& s) : options(o), in(o.in), frames(all_frames(o, in)), summary(s) {
        auto const first = in.path(frames.front()); // of all chunks, so that these go by the same views
        if (options.upsample) upsampling = upsampling_for(*options.upsample, in, frames);
        if (!options.chunk.empty()) frames = part_of(frames, chunk_in(options.chunk));
        views.emplace(options.map, std::vector{first, frames.empty() ? first : in.path(frames.front())});
        if (!options.preset.empty()) choice.preset = &preset_of(options.preset);
        output.emplace(options, in, frames);
        for (auto const number : frames) (options.skip_existing && output->has(number) ? summary.skipped : wanted).push_back(number);
        if (wanted.empty()) return;
        choice = views->choose(choice.preset, options.signal, in.path(wanted.front()));
        choice.preset = &preset_on(options.device, *choice.preset);
        summary.preset = choice.preset->name, summary.preset_reason = choice.reason, summary.signal = options.signal;
        for (auto const& view : views->all) {
            if (!options.layers.empty()) output->check(wanted.front(), view.names);
            if (view.names) output->check_levels(wanted.front(), *view.names);
            if (view.names && has_several()) summary.views.push_back({view.names->view, {}});
        }
        comparison.emplace(options, wanted);
        for (auto const& view : views->all) denoisers.emplace_back(settings_of(view));
    }

    void run() {
        if (wanted.empty()) return;
        auto const remembered = choice.preset->warm_up + frames_in_full();
        WarmUp const warm_up{options.warmup ? *options.warmup : remembered, !options.warmup};
        auto const steps = steps_for(wanted, warm_up, in.on_disk());
        Progress progress(choice.preset->name, static_cast<long long>(steps.size()), !options.quiet);
        for (std::size_t done = 0; auto const& step : steps) {
            progress.show(static_cast<long long>(done++), in.path(step.number).filename().string());
            if (step.begins)
                for (auto& denoiser : denoisers) denoiser.forget();
            if (step.is_written)
                write(step.number, progress);
            else
                warm_up_with(step.number, is_wanted_in_full(steps, done), progress);
        }
        comparison->finish();
    }

    /// Adds what the denoisers know, of a run that was stopped too.
    void finish() {
        if (output)
            for (auto const& remark : output->remarks()) summary.remarks.push_back(remark);
        if (denoisers.empty()) return;
        RepairedGuides guides;
        for (auto const& denoiser : denoisers) {
            guides += denoiser.repaired_guides();
            summary.missing_samples += denoiser.missing_samples();
            summary.milliseconds += denoiser.milliseconds();
        }
        remember_memory();
        summary.layout_changes = LayoutChanges::per_frame();
        auto const& names = denoisers.front().names();
        if (!names) return;
        if (auto const& how = denoisers.front().upsampling()) {
            summary.upsampled_by = how->method();
            if (!how->resolves()) remark("--upsample enlarges each frame by itself, bicubically: " + how->alone);
        }
        auto const& map = options.map;
        summary.renderer = !map.empty() && names->renderer == map && !find_renderer_map(map) ? in.text() : names->renderer;
        summary.remarks.insert(summary.remarks.begin(), names->remarks.begin(), names->remarks.end());
        for (auto const& denoiser : denoisers)
            if (denoiser.names())
                for (auto const& line : denoiser.names()->remarks) remark(line);
        for (auto const& denoiser : denoisers)
            for (auto const& line : denoiser.remarks()) remark(line);
        if (auto const left = views->remark()) remark(*left);
        for (auto const& name : without_reference) remark("the references do not have view " + name);
        if (guides.pixels > 0) {
            std::vector<std::string> each;
            guides.for_each(
                [&](auto guide, auto what, auto pixels) { each.push_back(fmt::format("{} {} in {}", guide.name, what, pixels)); });
            remark(fmt::format("{} pixels have guides that no scene has, which were repaired: {}", guides.pixels, fmt::join(each, ", ")));
        }
        for (auto const& line : stages.remarks()) remark(line);
        if (options.why) summary.why = stages.sentences();
        if (std::ranges::any_of(denoisers, &SequenceDenoiser::left_alpha))
            remark(fmt::format("alpha is as in the files{}: preset {} does not denoise it{}, general and final-frame do",
                               choice.preset->by_albedo ? " where there is light" : "", choice.preset->name,
                               choice.preset->by_albedo ? " with its light" : ""));
        if (auto const changes = denoisers.front().canvas_changes(); changes > 0)
            remark("history started afresh " + std::to_string(changes) +
                   " times, where data windows began to reach farther out of the display window");
    }

private:
    [[nodiscard]] bool has_several() const { return views->all.size() > 1; }

    [[nodiscard]] SequenceSettings settings_of(SequenceView const& view) const {
        return {.preset = *choice.preset,
                .threads = options.threads,
                .map = view.names,
                .shutter = options.shutter,
                .field_of_view = options.field_of_view,
                .later_frames = later_frames(options, *choice.preset),
                .keeps_alpha = options.keep_alpha,
                .stages = stages_of(options, *choice.preset),
                .accounts = options.why,
                .diagnose = options.diagnose,
                .upsampling = upsampling,
                .debug_views = options.debug_views};
    }
    /// Each once: views have most of them in common.
    void remark(std::string const& line) {
        if (std::ranges::find(summary.remarks, line) == summary.remarks.end()) summary.remarks.push_back(line);
    }
    void remember_memory() {
        double sum = 0;
        for (auto const& denoiser : denoisers) sum += denoiser.bytes_per_pixel();
        summary.bytes_per_pixel = std::max(summary.bytes_per_pixel, sum);
    }
    /// Ends a view's turn: only its history stays in memory, where others need the room.
    void end_turn(SequenceDenoiser& denoiser) {
        remember_memory();
        if (has_several()) denoiser.release_scratch();
    }
    [[nodiscard]] std::string name_of(std::size_t view) const { return has_several() ? views->all[view].names->view : std::string(); }

    void report_findings(long long number, std::size_t view, Progress& progress) {
        auto const of_view = has_several() ? ", view " + name_of(view) : "";
        for (auto const& finding : denoisers[view].findings()) {
            auto const text = "frame " + std::to_string(number) + of_view + ": " + to_string(finding);
            progress.say("quell-denoise: " + text);
            (finding.mistake == Mistake::not_checked ? summary.not_checked : summary.findings).push_back(text);
        }
    }
    /// Whether pictures of frames take part in those after them, beside their history.
    /// How many frames before one have pictures that take part in its own.
    [[nodiscard]] int frames_in_full() const {
        return (upsampling && upsampling->resolves() ? frames_of_upsampling : 0) +
               (has(stages_of(options, *choice.preset), "light") ? 1 : 0);
    }
    /// Whether one of the next steps writes a frame that the picture of the one before it takes part in.
    [[nodiscard]] bool is_wanted_in_full(std::vector<Step> const& steps, std::size_t next) const {
        auto const end = std::min(steps.size(), next + static_cast<std::size_t>(frames_in_full()));
        for (auto i = next; i < end && !steps[i].begins; ++i)
            if (steps[i].is_written) return true;
        return false;
    }
    /// Where nobody asked for these frames, a broken one is as good as none.
    void warm_up_with(long long number, bool in_full, Progress& progress) {
        for (std::size_t view = 0; view < denoisers.size(); ++view) {
            try {
                denoisers[view].warm_up(in, number, in_full);
            } catch (Error const&) {
                if (options.warmup) throw;
                denoisers[view].forget();
            }
            report_findings(number, view, progress);
            end_turn(denoisers[view]);
        }
        ++summary.warm_up_frames;
    }
    void write(long long number, Progress& progress) {
        for (auto const& view : views->all)
            if (view.names) output->check_levels(number, *view.names);
        std::vector<metrics::Picture> shown;
        std::string table = StageAccount::header;
        for (std::size_t view = 0; view < denoisers.size(); ++view) {
            auto& denoiser = denoisers[view];
            auto frame = denoiser.next_whole(in, number);
            report_findings(number, view, progress);
            summary.size = denoiser.displayed_size(frame.picture);
            shown.push_back(comparison->has(number) ? denoiser.displayed(frame.picture) : metrics::Picture{});
            output->add(number, frame, *denoiser.names());
            auto const prefix = has_several() ? word_of(name_of(view)) + "." : std::string();
            for (auto const& name : options.debug_views) output->write_views(number, name, prefix, denoiser.debug_images(name));
            stages.add(name_of(view), denoiser.account()), table += denoiser.account().table(name_of(view));
            if (options.why) output->write_why(number, prefix, denoiser.account().image());
            end_turn(denoiser);
        }
        output->write(number);
        if (options.why) output->write_why(number, table);
        summary.written.push_back(number);
        for (std::size_t view = 0; view < shown.size(); ++view) score(number, view, shown[view]);
    }
    void score(long long number, std::size_t view, metrics::Picture const& picture) {
        auto const& references = views->all[view].references;
        if (view == 0) comparison->add(number, picture, references, summary.scores);
        if (!has_several()) return;
        auto& rows = summary.views[view].scores;
        if (view == 0)
            rows = summary.scores;
        else if (!comparison->add_beside(number, picture, references, rows))
            without_reference.insert(name_of(view));
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

/// What a frame's images took is kept for the next frame's: the system would clear it each time, for a twentieth of all time.
void keep_memory() {
#if defined(__GLIBC__)
    constexpr int most_of_malloc = 32 << 20, most_kept = 1 << 30; // bytes
    mallopt(M_MMAP_THRESHOLD, most_of_malloc), mallopt(M_TRIM_THRESHOLD, most_kept);
#endif
}

} // namespace

#if defined(QUELL_DENOISE_ENTRY) // one of several instruction sets: dispatch.cpp.in calls it
extern "C" int QUELL_DENOISE_ENTRY(int argc, char** argv);
extern "C" int QUELL_DENOISE_ENTRY(int argc, char** argv) {
#else
int main(int argc, char** argv) {
#endif
    auto const body = [&] {
        keep_memory();
        auto const options = denoise_options(argc, argv);
        if (!options) return;
        if (options->plan) return print_plan(*options);
        if (!options->list) return denoise(*options);
        for (auto const& preset : presets_on(options->device)) std::cout << preset.name << '\n';
    };
    return exit_code_of("quell-denoise", body,
                        "choose a --preset that takes less (--plan says how much), or give --quick or --extra-frames 0");
}
