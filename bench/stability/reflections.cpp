#include "cases.hpp"
#include "own_presets.hpp"
#include "watch.hpp"

#include <random>

namespace quell::stability {
namespace {

void curved(std::string const& name, Making const& making, Results& results) {
    auto const sequence =
        traced({.scene = "restaurant", .signal = Signal::glossy, .scored_from = 28, .last = 34, .effect = tracer::Effect::curved}, making);
    auto const lens = record(results, name, examples::preset_of("glossy"), sequence, making.threads);
    auto const flat = record(results, name, glossy_of_flat_mirrors(), sequence, making.threads);
    results.promises.push_back({name, "glossy", "over_flat_mirror", mean_ratio(lens, flat), no_worse});
}

Shot temple_of(float roughness) {
    return {.scene = "temple",
            .signal = Signal::glossy,
            .scored_from = 28,
            .last = 34,
            .effect = tracer::Effect::glossy,
            .change = [roughness](tracer::SceneDescription& scene) {
                for (auto& material : scene.materials)
                    if (material.metallic > 0 || material.metallic_roughness_texture >= 0)
                        material.metallic_roughness_texture = -1, material.metallic = 0.6f, material.roughness = roughness;
            }};
}

/// Takes what the sample of another lobe gave, in these pixels.
void take(io::ExrImage& image, io::ExrImage const& other, std::vector<bool> const& pixels) {
    for (std::string const name : {"R", "G", "B", "glossy.R", "glossy.G", "glossy.B", "roughness.R", "glossy_hit.X", "glossy_hit.Y",
                                   "glossy_hit.Z", "glossy_hit_previous.X", "glossy_hit_previous.Y", "glossy_hit_previous.Z"}) {
        auto& values = plane(image, name);
        for (std::size_t i = 0; i < values.size(); ++i)
            if (pixels[i]) values[i] = other[name].values[i];
    }
}

/// A smooth coat over a rough ground: half of the light comes from each, and a sample follows one of them.
ScoredSequence coated(Making const& making) {
    auto coat = traced(temple_of(0.1f), making);
    auto const ground = traced(temple_of(0.45f), making);
    std::mt19937 random(making.seed + 1);
    for (std::size_t i = 0; i < coat.frames.size(); ++i) {
        std::vector<bool> chosen(coat.frames[i].pixels());
        for (auto&& each : chosen) each = random() % 2 == 0;
        take(coat.frames[i], ground.frames[i], chosen);
    }
    for (std::size_t i = 0; i < coat.references.size(); ++i)
        for (std::size_t p = 0; p < coat.references[i].pixels.size(); ++p)
            coat.references[i].pixels[p] = (coat.references[i].pixels[p] + ground.references[i].pixels[p]) * 0.5f;
    return coat;
}

void lobes(std::string const& name, Making const& making, Results& results) {
    auto const sequence = coated(making);
    auto const clamped = record(results, name, examples::preset_of("surface-clamp"), sequence, making.threads);
    auto const followed = record(results, name, examples::preset_of("glossy"), sequence, making.threads);
    results.promises.push_back({name, "glossy", "worst_frame_over_surface-clamp", worst_ratio(followed, clamped), no_worse});
}

} // namespace

std::vector<Case> reflection_cases() {
    return {{"curved", "Moving things seen in curved metal. The thin lens is better than a flat mirror.", curved},
            {"lobes", "A smooth coat over a rough ground: two lobes in a pixel. Bounded by the clamped baseline.", lobes}};
}

} // namespace quell::stability
