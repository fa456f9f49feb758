#include "cases.hpp"
#include "watch.hpp"

#include <tracer/scenes/scenes.hpp>

#include <algorithm>

namespace quell::stability {
namespace {

constexpr int event = static_cast<int>(tracer::event_frame);

/// After an event a method with all its history is held against the same one that was told to forget, whose noise is the same, and at the
/// event itself against the input.
void settle(std::string const& name, ScoredSequence const& sequence, std::vector<std::string> const& methods, int threads,
            Results& results) {
    auto const input = record(results, name, examples::preset_of("none"), sequence, threads);
    for (auto const& method : methods) {
        auto const& preset = examples::preset_of(method);
        auto const kept = record(results, name, preset, sequence, threads);
        auto const forgetful = watch(preset, sequence, {Memory::Kind::since, event}, threads);
        auto const fresh = record(results, name, method + "-fresh", sequence, forgetful);
        results.promises.push_back(
            {name, method, "first_frame_over_no_history", kept.front().errors["rmse"] / input.front().errors["rmse"], no_worse});
        results.promises.push_back({name, method, "worst_frame_over_fresh_start", worst_ratio(kept, fresh), 1.05});
    }
}

Shot shot_of(std::string const& scene) { return {.scene = scene, .scored_from = event, .last = event + 10}; }

void cut(std::string const& name, Making const& making, Results& results) {
    settle(name, traced(shot_of("cut"), making), {"surface", "surface-clamp", "svgf", "general", "final-frame", "dual-color", "trmv"},
           making.threads, results);
}

/// A host that doesn't notice: its motion says that nothing has moved.
void cut_unnoticed(std::string const& name, Making const& making, Results& results) {
    auto sequence = traced(shot_of("cut"), making);
    auto& frame = sequence.frames[static_cast<std::size_t>(event - sequence.first)];
    for (auto const* const component : {"motion.X", "motion.Y"}) std::ranges::fill(plane(frame, component), 0.f);
    settle(name, sequence, {"surface", "surface-clamp", "svgf", "general", "final-frame", "dual-color"}, making.threads, results);
}

void lightswitch(std::string const& name, Making const& making, Results& results) {
    settle(name, traced(shot_of("lightswitch"), making), {"surface", "surface-clamp", "svgf", "general", "final-frame", "asvgf", "trmv"},
           making.threads, results);
}

} // namespace

std::vector<Case> event_cases() {
    return {{"cut", "The camera is somewhere else at once; motion vectors say so. Settles like a fresh start.", cut},
            {"cut-unnoticed", "The same with motion vectors of zero, in a room of the same shape.", cut_unnoticed},
            {"lightswitch", "A light goes on. Settles like a fresh start.", lightswitch}};
}

} // namespace quell::stability
