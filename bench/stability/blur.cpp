#include "cases.hpp"
#include "watch.hpp"

#include <tracer/lighting.hpp>
#include <tracer/scenes/scenes.hpp>

#include <algorithm>
#include <cmath>

namespace quell::stability {
namespace {

constexpr int event = static_cast<int>(tracer::event_frame);

/// Pixels with less than a tenth of the light that they should have.
int holes(ScoredSequence const& sequence, Pictures const& pictures) {
    int count = 0;
    for (int i = sequence.scored_from; i <= sequence.last(); ++i) {
        auto const &truth = sequence.reference(i).pixels, &shown = pictures[static_cast<std::size_t>(i - sequence.scored_from)].pixels;
        for (std::size_t p = 0; p < truth.size(); ++p)
            if (tracer::luminance(truth[p]) > 0.02f && !(tracer::luminance(shown[p]) > 0.1f * tracer::luminance(truth[p]))) ++count;
    }
    return count;
}

/// How far the light of all scored frames is from what it should be, relatively.
double energy_error(ScoredSequence const& sequence, Pictures const& pictures) {
    double shown = 0, truth = 0;
    for (int i = sequence.scored_from; i <= sequence.last(); ++i) {
        for (auto const& pixel : pictures[static_cast<std::size_t>(i - sequence.scored_from)].pixels) shown += tracer::luminance(pixel);
        for (auto const& pixel : sequence.reference(i).pixels) truth += tracer::luminance(pixel);
    }
    return std::abs(shown / truth - 1);
}

/// The worst frame's FLIP over that of the mean frame.
double worst_over_mean(FrameErrors const& errors) {
    double sum = 0, worst = 0;
    for (auto const& each : errors) sum += each.errors["flip"], worst = std::max(worst, each.errors["flip"]);
    return worst * static_cast<double>(errors.size()) / sum;
}

bool is_noisy_in_time_only(std::string const& scene) { return !tracer::built_in_scene(scene).secondary_rays; }

/// @param methods those that the case is about
void blurred(std::string const& name, std::string const& scene, std::vector<std::string> const& methods, Making const& making,
             Results& results) {
    auto const sequence =
        traced({.scene = scene, .scored_from = event - 4, .last = event + 6, .effect = tracer::Effect::blur, .shutter = 0.5f}, making);
    auto const input = record(results, name, examples::preset_of("none"), sequence, making.threads);
    for (auto const& method : methods) {
        auto const pictures = watch(examples::preset_of(method), sequence, {}, making.threads);
        auto const denoised = record(results, name, method, sequence, pictures);
        auto const promise = [&](char const* metric, double value, double limit) {
            results.promises.push_back({name, method, metric, value, limit});
        };
        promise("over_input", mean_ratio(denoised, input), no_worse);
        if (!is_noisy_in_time_only(scene)) continue; // shadows of one sample are black here and there
        promise("holes", static_cast<double>(holes(sequence, pictures)), 0);
        promise("energy_error", energy_error(sequence, pictures), 0.01);
        promise("worst_over_mean", worst_over_mean(denoised), 1.3);
    }
}

void linear(std::string const& name, Making const& making, Results& results) {
    blurred(name, "spheres", {"blur", "blur-straight"}, making, results);
}
void crossing(std::string const& name, Making const& making, Results& results) {
    blurred(name, "mixed", {"blur", "blur-straight"}, making, results);
}
void panning(std::string const& name, Making const& making, Results& results) {
    blurred(name, "colonnade", {"blur", "blur-straight"}, making, results);
}
void reversing(std::string const& name, Making const& making, Results& results) { blurred(name, "reverse", {"blur"}, making, results); }
void rotating(std::string const& name, Making const& making, Results& results) { blurred(name, "propeller", {"blur"}, making, results); }
void rolling(std::string const& name, Making const& making, Results& results) { blurred(name, "roll", {"blur"}, making, results); }
/// Shadows are noisy as well as blurred, and move otherwise than what they lie on.
void shadows(std::string const& name, Making const& making, Results& results) {
    blurred(name, "fence", {"blur", "blur-split"}, making, results);
}

} // namespace

std::vector<Case> blur_cases() {
    return {
        {"blur-linear",
         "What those below are held against: motion in straight lines. No holes, the light to 1 %, no frame much worse than others, and "
         "less error than the input.",
         linear},
        {"blur-crossing", "Something moves before something else that moves another way.", crossing},
        {"blur-panning", "Columns at many depths, past which the camera moves.", panning},
        {"blur-rolling", "The camera rolls.", rolling},
        {"blur-reversing", "Things turn back while the shutter is open.", reversing},
        {"blur-rotating", "A propeller.", rotating},
        {"blur-shadows", "Shadows that move under an open shutter, with the surface's sweep instead of their own.", shadows}};
}

} // namespace quell::stability
