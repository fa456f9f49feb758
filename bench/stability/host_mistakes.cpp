#include "cases.hpp"

#include <denoise/presets.hpp>
#include <quell/diagnose/finding.hpp>

#include <algorithm>

namespace quell::stability {
namespace {

/// Cameras that move by more than a pixel a frame, for that is the evidence: one flies, one turns.
std::vector<Shot> shots() {
    return {{.scene = "temple", .scored_from = 6, .last = 5}, {.scene = "pan", .first = 26, .scored_from = 32, .last = 31}};
}

/// A convention that isn't quell's, handed over as if it were.
struct HostMistake {
    std::string name;
    Mistake finding;
    float x, y; ///< what a good vector is multiplied by
};

std::vector<HostMistake> host_mistakes(Extent size) {
    auto const width = static_cast<float>(size.width), height = static_cast<float>(size.height);
    return {{"sign", Mistake::motion_sign, -1, -1},
            {"uv", Mistake::motion_unit, 1 / width, 1 / height},
            {"ndc", Mistake::motion_unit, 2 / width, 2 / height},
            {"y_up", Mistake::motion_y, 1, -1}};
}

void scale(std::vector<float>& values, float by) {
    std::ranges::transform(values, values.begin(), [by](float value) { return value * by; });
}

/// Whether what is said first of a frame that has another before it is not this; without a mistake, whether anything is said.
double misnamed(examples::Preset const& preset, ScoredSequence sequence, HostMistake const* mistake, int threads) {
    auto const denoiser = examples::denoiser_of(preset, sequence.size, threads);
    denoiser->diagnose();
    double count = 0;
    for (int i = sequence.first; i <= sequence.last(); ++i) {
        auto& frame = sequence.frames[static_cast<std::size_t>(i - sequence.first)];
        if (mistake) scale(plane(frame, "motion.X"), mistake->x), scale(plane(frame, "motion.Y"), mistake->y);
        static_cast<void>(denoiser->denoise(frame, {}, i));
        auto const& found = denoiser->findings();
        bool const silent = found.empty(), named = !silent && mistake && found.front().mistake == mistake->finding;
        if (i > sequence.first) count += mistake ? !named : !silent;
    }
    return count;
}

void motion_of_another_convention(std::string const& name, Making const& making, Results& results) {
    for (auto const& shot : shots()) {
        auto const sequence = traced(shot, making);
        for (std::string const method : {"surface", "trmv"}) {
            auto const& preset = examples::preset_of(method);
            auto const promise = [&](std::string const& metric, HostMistake const* mistake) {
                results.promises.push_back(
                    {name, method, shot.scene + "_" + metric, misnamed(preset, sequence, mistake, making.threads), 0});
            };
            promise("frames_with_a_false_alarm", nullptr);
            for (auto const& mistake : host_mistakes(making.size)) promise("frames_that_misname_" + mistake.name, &mistake);
        }
    }
}

} // namespace

std::vector<Case> host_mistake_cases() {
    return {{"host-mistakes",
             "Motion vectors of the wrong sign, unit or direction of y. quell::diagnose names that first, and says nothing of good ones.",
             motion_of_another_convention}};
}

} // namespace quell::stability
