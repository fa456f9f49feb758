#include "cases.hpp"
#include "watch.hpp"

#include <tracer/lighting.hpp>
#include <tracer/scenes/scenes.hpp>

namespace quell::stability {
namespace {

constexpr int event = static_cast<int>(tracer::event_frame);

/// Pixels with less than a tenth of the light that they should have.
int holes(Sequence const& sequence, Pictures const& pictures) {
    int count = 0;
    for (int i = sequence.scored_from; i <= sequence.last(); ++i) {
        auto const &truth = sequence.reference(i).pixels, &shown = pictures[static_cast<std::size_t>(i - sequence.scored_from)].pixels;
        for (std::size_t p = 0; p < truth.size(); ++p)
            if (tracer::luminance(truth[p]) > 0.02f && !(tracer::luminance(shown[p]) > 0.1f * tracer::luminance(truth[p]))) ++count;
    }
    return count;
}

bool is_noisy_in_time_only(std::string const& scene) { return !tracer::built_in_scene(scene).secondary_rays; }

void blurred(std::string const& name, std::string const& scene, Making const& making, Results& results) {
    auto const sequence =
        traced({.scene = scene, .scored_from = event - 4, .last = event + 6, .effect = tracer::Effect::blur, .shutter = 0.5f}, making);
    auto const input = errors(sequence, watch(examples::preset_of("none"), sequence, {}, making.threads));
    auto const pictures = watch(examples::preset_of("blur"), sequence, {}, making.threads);
    auto const denoised = errors(sequence, pictures);
    record(results, name, "none", input);
    record(results, name, "blur", denoised);
    results.promises.push_back({name, "blur", "over_input", mean_ratio(denoised, input), no_worse});
    // Shadows of one sample are black here and there.
    if (is_noisy_in_time_only(scene))
        results.promises.push_back({name, "blur", "holes", static_cast<double>(holes(sequence, pictures)), 0});
}

void linear(std::string const& name, Making const& making, Results& results) { blurred(name, "spheres", making, results); }
void reversing(std::string const& name, Making const& making, Results& results) { blurred(name, "reverse", making, results); }
void rotating(std::string const& name, Making const& making, Results& results) { blurred(name, "propeller", making, results); }
/// Shadows are noisy as well as blurred, and move otherwise than what they lie on.
void shadows(std::string const& name, Making const& making, Results& results) { blurred(name, "fence", making, results); }

} // namespace

std::vector<Case> blur_cases() {
    return {{"blur-linear", "What those below are held against: motion in straight lines. No holes, and less error than the input.", true,
             linear},
            {"blur-reversing", "Things turn back while the shutter is open.", true, reversing},
            {"blur-rotating", "A propeller.", true, rotating},
            {"blur-shadows", "Shadows that move under an open shutter, with the surface's sweep instead of their own.", true, shadows}};
}

} // namespace quell::stability
