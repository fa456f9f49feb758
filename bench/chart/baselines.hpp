#pragma once

#include "chart_effect.hpp"

#include <quell/presets/published.hpp>

namespace quell::bench {

/// References to the numbers that a sweep changes, for Named::vary. `stage<i>` counts from the pipeline's first stage.
template <std::size_t i> auto& stage(auto& pipeline) { return std::get<i>(pipeline.stages); }

/// svgf's numbers, where the Temporal stage is number `temporal` and the wavelet comes behind it.
template <std::size_t temporal, class N> auto vary_guided_atrous(N const& named) {
    return named
        .vary(
            "levels", {1, 2, 3, 4, 5, 6}, [](auto& p) -> auto& { return stage<temporal + 1>(p).kernel.levels; })
        .vary(
            "sigma", {1, 2, 3, 4, 6}, [](auto& p) -> auto& { return stage<temporal + 1>(p).kernel.sigma_luminance; });
}
inline constexpr std::initializer_list<double> caps{2, 4, 8, 16, 32}, alphas{0.05, 0.1, 0.2, 0.4};

/// svgf with a wavelet of another shape.
template <class Spline> constexpr auto svgf_with(Spline, ChannelTag auto signal, auto... parts) {
    return Pipeline{signal, parts..., Temporal{SurfaceMotion{}, WithMoments{RunningMean{.cap = 5.f}}},
                    Spatial{VarianceGuidedAtrous<Product<DepthEdge, NormalEdge>, Spline>{}}};
}

/// The methods that serve any signal, with their variants.
auto baselines(ChannelTag auto signal, auto... parts) {
    auto const cap = [](auto& p) -> auto& { return stage<0>(p).blending.inner.cap; };
    auto const svgf = vary_guided_atrous<0>(Named{"svgf", presets::svgf(signal, parts...)}.vary("cap", caps, cap));
    auto const general = Named{"general", presets::general(signal, parts...)}
                             .vary(
                                 "gain", {25, 50, 200}, [](auto& p) -> auto& { return stage<1>(p).blending.inner.gain; })
                             .vary(
                                 "levels", {2, 3, 4, 6}, [](auto& p) -> auto& { return stage<2>(p).kernel.levels; });
    return std::tuple(
        Named{"none", presets::none(signal, parts...)},
        Named{"surface", presets::surface(signal, parts...)}.vary(
            "alpha", alphas, [](auto& p) -> auto& { return stage<0>(p).blending.alpha; }),
        Named{"surface-clamp", presets::surface_clamp(signal, parts...)}
            .vary(
                "alpha", alphas, [](auto& p) -> auto& { return stage<0>(p).blending.inner.alpha; })
            .vary(
                "sigmas", {0.5, 1, 2, 3}, [](auto& p) -> auto& { return stage<0>(p).blending.range.sigmas; }),
        Named{"atrous", presets::atrous(signal, parts...)}.vary(
            "levels", {1, 2, 3, 4, 5, 6}, [](auto& p) -> auto& { return stage<0>(p).kernel.levels; }),
        variant_of({"atrous", "taps", 3., 5.}, Pipeline{signal, parts..., Spatial{Atrous<Product<DepthEdge, NormalEdge>, LinearSpline>{}}}),
        general, general.in_half(), svgf, svgf.in_half(), variant_of({"svgf", "taps", 3., 5.}, svgf_with(LinearSpline{}, signal, parts...)),
        vary_guided_atrous<1>(Named{"asvgf", presets::asvgf(signal, parts...)})
            .vary(
                "cap", caps, [](auto& p) -> auto& { return stage<1>(p).blending.inner.inner.cap; }));
}

/// Charts the baselines, and the methods that are for this effect only.
void chart_with_baselines(Job const& job, ChannelTag auto signal, std::vector<tracer::Effect> const& effects, auto const& baseline_methods,
                          auto const&... own) {
    tracer::RenderSettings const one_sample{.size = job.options.size, .seed = job.options.seed, .threads = job.options.threads};
    chart_feeds(job, signal, effects, Feed{one_sample, std::tuple_cat(baseline_methods, std::tuple(own...))});
}

} // namespace quell::bench
