#pragma once

#include <quell/blur/moving_and_static/directional_atrous.hpp>
#include <quell/blur/moving_and_static/layer_history.hpp>
#include <quell/blur/moving_and_static/layer_split.hpp>
#include <quell/blur/moving_and_static/path_gather.hpp>
#include <quell/blur/moving_and_static/sample_collector.hpp>
#include <quell/blur/post_process/gather_blur.hpp>
#include <quell/blur/post_process/tile_max_blur.hpp>
#include <quell/filter/change/temporal_gradient.hpp>
#include <quell/motion/reflection/glossy_motion.hpp>
#include <quell/presets/blur.hpp>
#include <quell/presets/effects.hpp>
#include <quell/presets/general.hpp>
#include <quell/radiance/cone_atrous.hpp>

/// Published methods, to be measured against: the papers' own versions of quell's presets, and what they compare with.
namespace quell::presets {

/// svgf whose history shortens where the host's temporal gradients say that the light itself has changed (Schied 2018).
template <ChannelTag S> constexpr auto asvgf(S signal, auto... parts) {
    return Pipeline{signal, parts..., Spatial{TemporalGradient<S>{}},
                    Temporal{SurfaceMotion{}, WithMoments{Antilag{RunningMean{.cap = 5.f}}}},
                    Spatial{VarianceGuidedAtrous{Product{DepthEdge{}, NormalEdge{}}}}};
}

/// History along the image in a mirror, clamped (Zimmer 2015, Mara 2017).
constexpr auto mirror_clamp(ChannelTag auto signal, auto... parts) {
    return Pipeline{
        signal, parts...,
        Temporal{FirstValid{MirrorMotion{}, SurfaceMotion{}}, Clamped{Exponential{.alpha = 0.1f}, MeanDeviation{.sigmas = 1.f}}}};
}

constexpr auto shadow_paper(ChannelTag auto signal, auto... parts) {
    return Pipeline{signal,
                    parts...,
                    Spatial{ShadowSplat{}},
                    Spatial{AdaptiveBilateral<PenumbraWidth>{.width = {.part = 0.25f, .part_of_least = 1e9f}, .radius = 15}},
                    Temporal{FirstValid{SplattedShadowMotion{}, SurfaceMotion{}},
                             Clamped{WithCleanUp{NonPlanarFalloff{Exponential{.alpha = 0.1f}}}, MeanDeviation{.sigmas = 3.f}}},
                    Spatial{CleanUp<>{}}};
}

constexpr auto glossy_paper(ChannelTag auto signal, auto... parts) {
    return Pipeline{signal, parts...,
                    Temporal{FirstValid{GlossyMotion{}, SurfaceMotion{}},
                             Clamped{WithCleanUp{Exponential{.alpha = 0.1f}}, MeanDeviation{.sigmas = 3.f}}},
                    Spatial{CleanUp<>{}}};
}

/// Diffuse indirect light with history even for what has just been uncovered (TRMV section 4.3), as a colour: svgf with a second source.
/// Little trust is best for colours: what is alike is not the same.
constexpr auto dual_color(ChannelTag auto signal, auto... parts) {
    using Alike = AllOf<SimilarDepth, SameNormal>;
    return Pipeline{signal, parts...,
                    Temporal{FirstValid{SurfaceMotion{}, DualMotion<Alike>{.trust = 0.1f}}, WithMoments{RunningMean{.cap = 5.f}}},
                    Spatial{VarianceGuidedAtrous{Product{DepthEdge{}, NormalEdge{}}}}};
}

constexpr auto dual_cone_paper(ChannelTag auto signal, auto... parts) {
    return Pipeline{signal, Cones{}, parts..., Temporal{FirstValid{SurfaceMotion{}, DualMotion{}}, RunningMean{.cap = 32.f}, ConeFetch{}},
                    Spatial{ConeAtrous<Product<DepthEdge, NormalEdge>>{.least_cosine = 0.9f}}};
}

/// blur with plain reprojection instead of the search.
template <ChannelTag S> constexpr auto blur_one_step(S signal, PathSearch search = {}) {
    search.iterations = 0;
    return blur(signal, search);
}

/// blur in the paper's two layers: what moves and what stands still, from a guide of the mean motion around; both accumulated; and a
/// wavelet along the motion. What was gathered is blurred as it should be already, so that the wavelet stays narrower than the paper's.
template <ChannelTag S>
constexpr auto blur_wavelet(S signal, PathSearch search = {}, DirectionalAtrous<S> along = {.reach = 0.05f, .taps_across = 0}) {
    return Pipeline{signal, Spatial{MotionGuide<>{}}, Spatial{PathGather<S>{}}, Temporal{search, LayerBlend<S>{}, LayerFetch<S>{}},
                    Spatial{along}};
}

/// blur_wavelet with the paper's own first steps and numbers: samples collected by a pre-filter, and two layers from the 5x5 around. Other
/// than in the paper, the guide is of full resolution, with angles doubled instead of relative to the centre's sample; what stands still is
/// remembered, not averaged; and the past is interpolated by a spline.
template <ChannelTag S> constexpr auto blur_paper(S signal, PathSearch search = {.iterations = 2}) {
    return Pipeline{signal,
                    Spatial{MotionGuide<>{}},
                    Spatial{SampleCollector<>{}},
                    Spatial{LayerSplit<S>{}},
                    Temporal{search, LayerBlend<S>{}, LayerFetch<S>{}},
                    Spatial{DirectionalAtrous<S>{}}};
}

/// blur_paper without the pre-filter.
template <ChannelTag S> constexpr auto blur_no_pre_filter(S signal, PathSearch search = {.iterations = 2}) {
    return Pipeline{signal, Spatial{MotionGuide<>{}}, Spatial{LayerSplit<S>{}}, Temporal{search, LayerBlend<S>{}, LayerFetch<S>{}},
                    Spatial{DirectionalAtrous<S>{}}};
}

/// blur_wavelet with an ordinary a-trous wavelet, whose steps don't follow the motion.
template <ChannelTag S> constexpr auto blur_fixed_step(S signal, PathSearch search = {}) {
    return blur_wavelet(signal, search, {.fixed_step = 1.f, .taps_across = 2});
}

/// Motion blur of a picture without any, that of the middle of the open shutter: along each pixel's own sweep (GPU Gems 3, ch. 27), and
/// along the longest one around it (McGuire 2012).
constexpr auto gather_blur(ChannelTag auto signal, auto... parts) { return Pipeline{signal, parts..., Spatial{GatherBlur{}}}; }

constexpr auto tilemax_blur(ChannelTag auto signal, auto... parts) { return Pipeline{signal, parts..., Spatial{TileMaxBlur{}}}; }

template <class... Parts> constexpr auto trmv_paper(Parts... parts) {
    return Composite{shadow_paper(visibility, parts...), glossy_paper(quell::glossy, parts...), dual_cone_paper(indirect, parts...)};
}

} // namespace quell::presets
