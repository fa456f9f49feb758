#include "baselines.hpp"

#include <quell/presets/published.hpp>

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
    auto const blur = Named{"blur", presets::blur(radiance)}
                          .vary(
                              "count", {8, 16, 32, 128}, [](auto& p) -> auto& { return stage<1>(p).kernel.count; })
                          .vary(
                              "tile_width", {4, 16, 32}, [](auto& p) -> auto& { return stage<1>(p).kernel.tile_width; })
                          .vary(
                              "width", {0.75, 1.5, 2}, [](auto& p) -> auto& { return stage<1>(p).kernel.width; })
                          .vary(
                              "iterations", {0, 1, 2, 8}, [](auto& p) -> auto& { return stage<2>(p).motion.iterations; })
                          .vary(
                              "cap", caps, [](auto& p) -> auto& { return stage<2>(p).blending.cap; });
    auto const adaptive = Named{"blur-adaptive", presets::blur<RotatingTrajectories, AdaptiveFootprint>(radiance)}.vary(
        "allowed_error", {0.05, 0.1, 0.4}, [](auto& p) -> auto& { return stage<1>(p).kernel.footprint.allowed_error; });
    return std::tuple(Named{"none", presets::none(radiance)}, Named{"svgf", presets::svgf(radiance)}, blur, blur.in_half(),
                      Named{"blur-straight", presets::blur<StraightTrajectories>(radiance)},
                      Named{"blur-bent", presets::blur<BentTrajectories>(radiance)},
                      Named{"blur-one-step", presets::blur_one_step(radiance)},
                      Named{"blur-no-history", Pipeline{radiance, Spatial{PairGuide<RotatingTrajectories>{}},
                                                        Spatial{PairGather<Radiance, RotatingTrajectories>{}}, no_history}},
                      Named{"blur-few-samples", presets::blur(radiance, {}, {.count = 32})}, adaptive,
                      Named{"blur-wavelet", presets::blur_wavelet(radiance)}, Named{"blur-fixed-step", presets::blur_fixed_step(radiance)},
                      Named{"blur-paper", presets::blur_paper(radiance)},
                      Named{"blur-no-pre-filter", presets::blur_no_pre_filter(radiance)}, Named{"blur-split", presets::blur_split()});
}
/// Get a picture of the middle of the open shutter.
auto post_processes() {
    return std::tuple(Named{"gather-blur", presets::gather_blur(radiance)}, Named{"tilemax-blur", presets::tilemax_blur(radiance)});
}
} // namespace

void chart_blur(Job const& job) {
    tracer::RenderSettings const blurred{
        .size = job.options.size, .seed = job.options.seed, .threads = job.options.threads, .shutter = 0.5f};
    auto frozen = blurred;
    frozen.frozen_at = 0.5f;
    auto const input = [&](int samples, char const* name, bool stratified = true) {
        auto settings = blurred;
        settings.samples_per_pixel = samples;
        settings.stratified_times = stratified;
        Named shown{name, presets::none(radiance)};
        shown.competes = false;
        return Feed{settings, std::tuple(shown), true};
    };
    chart_feeds(job, radiance, {tracer::Effect::blur}, Feed{blurred, denoisers()}, Feed{frozen, post_processes()}, input(4, "none-4spp"),
                input(8, "none-8spp"), input(16, "none-16spp"), input(8, "none-8spp-random", false), input(16, "none-16spp-random", false));
}

} // namespace quell::bench
