#include "cases.hpp"
#include "watch.hpp"

#include <quell/execute/threads.hpp>
#include <quell/io/frame_image.hpp>
#include <quell/pipeline/steady_guides.hpp>
#include <quell/presets/general.hpp>

namespace quell::stability {
namespace {

constexpr int guide_samples = 16;

/// What `general` makes of the sequence where the depth is accumulated first.
Pictures with_steady_depth(ScoredSequence const& sequence, int threads) {
    constexpr auto denoise = presets::general(radiance, Demodulate{});
    Frame frame{sequence.size, denoise};
    History history{sequence.size, denoise};
    SteadyGuides<Channels<Depth>> steady{sequence.size};
    Threads<> const executor{.count = threads};
    Pictures pictures;
    for (int i = sequence.first; i <= sequence.last(); ++i) {
        io::load(frame, sequence.frame(i));
        frame.number = i;
        steady.apply(frame, executor);
        auto picture = metrics::picture_of(run(denoise, frame, history, executor));
        if (i >= sequence.scored_from) pictures.push_back(std::move(picture));
    }
    return pictures;
}

/// Samples of a pixel see different things. Guides of more samples than the signal has help, and history does not hurt.
void mixed(std::string const& name, std::string const& scene, Making const& making, Results& results) {
    Shot shot{.scene = scene, .scored_from = 28, .last = 31};
    auto const own = traced(shot, making); // with guides of the one sample
    shot.guide_samples = guide_samples;
    auto const sequence = traced(shot, making);
    auto const input = record(results, name, examples::preset_of("none"), sequence, making.threads);
    auto const steady = record(results, name, "general-steady-depth", sequence, with_steady_depth(sequence, making.threads));
    for (std::string const method : {"general", "final-frame"}) {
        auto const& preset = examples::preset_of(method);
        auto const shown = record(results, name, preset, sequence, making.threads);
        auto const by_own = record(results, name, method + "-guides-of-one-sample", own, watch(preset, own, {}, making.threads));
        auto const alone =
            record(results, name, method + "-no-history", sequence, watch(preset, sequence, {Memory::Kind::none}, making.threads));
        results.promises.push_back({name, method, "error_over_input", mean_ratio(shown, input), 0.6});
        if (method == "general") results.promises.push_back({name, method, "steady_depth_over_its_own", mean_ratio(steady, shown), 0.95});
        results.promises.push_back({name, method, "over_guides_of_one_sample", mean_ratio(shown, by_own), no_worse});
        results.promises.push_back({name, method, "worst_frame_over_no_history", worst_ratio(shown, alone), no_worse});
    }
}

void depth_of_field(std::string const& name, Making const& making, Results& results) { mixed(name, "lens", making, results); }
void half_seen(std::string const& name, Making const& making, Results& results) { mixed(name, "pane", making, results); }

} // namespace

std::vector<Case> mixed_pixel_cases() {
    return {{"depth-of-field",
             "Most things are out of focus: samples of a pixel see different ones. Guides of 16 samples help, and history too.",
             depth_of_field},
            {"half-seen", "Panes before things that move: a sample meets the pane or what is behind it. Likewise.", half_seen}};
}

} // namespace quell::stability
