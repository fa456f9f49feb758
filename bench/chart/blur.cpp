#include "chart_presets.hpp"

namespace quell::bench {
namespace {
/// Keeps the history out of a pipeline.
struct NoPast {
    QUELL_KERNEL auto previous(auto px) const {
        using Real = typename decltype(px)::Real;
        return Reprojection<Real>{px.position(), Real(0.f)};
    }
};

/// Get one sample per pixel, each at a time of its own.
auto denoisers() {
    Temporal const no_history{NoPast{}, PairBlend<Radiance>{}};
    PairGather<Radiance, RotatingTrajectories> const gather{};
    return std::tuple_cat(std::tuple(Charted{"none", presets::none(radiance)}, Charted{"svgf", presets::svgf(radiance)},
                                     Charted{"general", presets::general(radiance)}),
                          charted_presets<BlurInput::samples>(radiance),
                          std::tuple(Charted{"blur-no-history", Pipeline{radiance, Spatial{PairGuide<RotatingTrajectories>{}},
                                                                         Spatial{gather}, Spatial{DirectionalMean{gather}}, no_history}},
                                     Charted{"blur-few-samples", presets::blur(radiance, {}, {.count = 32})}));
}
} // namespace

void chart_blur(ChartRequest const& request) {
    tracer::RenderSettings const blurred{
        .size = request.options.size, .seed = request.options.seed, .threads = request.options.threads, .shutter = 0.5f};
    auto frozen = blurred;
    frozen.frozen_at = 0.5f;
    auto const input = [&](int samples, char const* name, bool stratified = true) {
        auto settings = blurred;
        settings.samples_per_pixel = samples;
        settings.stratified_times = stratified;
        Charted shown{name, presets::none(radiance)};
        shown.competes = false;
        return Feed{settings, std::tuple(shown), true};
    };
    chart_feeds(request, radiance, {tracer::Effect::blur}, Feed{blurred, denoisers()},
                Feed{frozen, charted_presets<BlurInput::picture>(radiance)}, input(4, "none-4spp"), input(8, "none-8spp"),
                input(16, "none-16spp"), input(8, "none-8spp-random", false), input(16, "none-16spp-random", false));
}

} // namespace quell::bench
