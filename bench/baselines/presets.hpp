#pragma once

#include <baselines/colour_cones.hpp>
#include <baselines/glossy_motion.hpp>
#include <baselines/moving_and_static/directional_atrous.hpp>
#include <baselines/moving_and_static/layer_history.hpp>
#include <baselines/moving_and_static/layer_split.hpp>
#include <baselines/moving_and_static/path_gather.hpp>
#include <baselines/moving_and_static/sample_collector.hpp>
#include <baselines/post_process/gather_blur.hpp>
#include <baselines/post_process/tile_max_blur.hpp>
#include <baselines/temporal_gradient.hpp>
#include <quell/presets/blur.hpp>
#include <quell/presets/effects.hpp>
#include <quell/presets/general.hpp>

/// Published methods for comparison: the papers' own versions of quell's presets, and baselines.
namespace quell::inline QUELL_INSTRUCTION_SET::presets {

/// svgf() whose history shortens where the host's temporal gradients show that the light has changed (Schied et al. 2018).
template <ChannelTag S> constexpr auto asvgf(S signal, auto... options) {
    return Pipeline{signal, options..., Spatial{TemporalGradient<S>{}},
                    Temporal{SurfaceMotion{}, WithMoments{Antilag{RunningMean{.cap = 5.f}}}},
                    Spatial{VarianceGuidedAtrous{Product{DepthEdge{}, NormalEdge{}}}}};
}

/// Accumulation along the motion of the mirror image, clamped (Zimmer 2015, Mara 2017).
constexpr auto mirror_clamp(auto signal, auto... options) {
    return Pipeline{
        signal, options...,
        Temporal{FirstValid{MirrorMotion{}, SurfaceMotion{}}, Clamped{Exponential{.alpha = 0.1f}, MeanDeviation{.sigmas = 1.f}}}};
}

/// Shadows as in TRMV section 4.1: shadow() with the numbers of the paper.
constexpr auto shadow_paper(auto signal, auto... options) {
    return Pipeline{signal,
                    options...,
                    Spatial{ShadowSplat{}},
                    Spatial{AdaptiveBilateral<PenumbraWidth>{.width = {.part = 0.25f, .min_width_part = 1e9f}, .radius = 15}},
                    Temporal{FirstValid{SplattedShadowMotion{}, SurfaceMotion{}},
                             Clamped{WithCleanUp{NonPlanarFalloff{Exponential{.alpha = 0.1f}}}, MeanDeviation{.sigmas = 3.f}}},
                    Spatial{CleanUp<>{}}};
}

/// Glossy reflections as in TRMV section 4.2: motion vectors are drawn from the lobe.
constexpr auto glossy_paper(auto signal, auto... options) {
    return Pipeline{signal, options...,
                    Temporal{FirstValid{GlossyMotion{}, SurfaceMotion{}},
                             Clamped{WithCleanUp{Exponential{.alpha = 0.1f}}, MeanDeviation{.sigmas = 3.f}}},
                    Spatial{CleanUp<>{}}};
}

/// Diffuse indirect light as a colour: svgf() whose disoccluded pixels take history by dual motion vectors (TRMV section 4.3). It trusts
/// that history little: a similar surface may have other light.
constexpr auto dual_color(auto signal, auto... options) {
    using Alike = AllOf<SimilarDepth, SameNormal>;
    return Pipeline{signal, options...,
                    Temporal{FirstValid{SurfaceMotion{}, DualMotion<Alike>{.trust = 0.1f}}, WithMoments{RunningMean{.cap = 5.f}}},
                    Spatial{VarianceGuidedAtrous{Product{DepthEdge{}, NormalEdge{}}}}};
}

/// Diffuse indirect light as in TRMV section 4.3: six cones in every pass.
constexpr auto dual_cone_paper(auto signal, auto... options) {
    return Pipeline{signal, Cones{}, options..., Temporal{FirstValid{SurfaceMotion{}, DualMotion{}}, RunningMean{.cap = 32.f}, ConeFetch{}},
                    Spatial{ConeAtrous<Product<DepthEdge, NormalEdge>>{.min_cosine = 0.9f}}};
}

/// blur() with plain reprojection instead of the search for the history.
template <ChannelTag S> constexpr auto blur_one_step(S signal, PathSearch search = {}) {
    search.iterations = 0;
    return blur(signal, search);
}

/// Motion blur with the foreground and background layers of MB: what moves, and what stands still. Samples are found by a guide of the mean
/// motion around; both layers are accumulated; a wavelet follows along the motion. It is narrower than in MB, since gathered samples are
/// already blurred.
template <ChannelTag S>
constexpr auto blur_wavelet(S signal, PathSearch search = {}, DirectionalAtrous<S> along = {.reach = 0.05f, .taps_across = 0}) {
    return Pipeline{signal, Spatial{MotionGuide<>{}}, Spatial{PathGather<S>{}}, Temporal{search, LayerBlend<S>{}, LayerFetch<S>{}},
                    Spatial{along}};
}

/// Motion blur as in MB sections 4.2 and 4.3: a pre-filter collects samples, and the layers are made from the 5x5 around. Four things
/// differ from MB. The guide is of full resolution. It averages doubled angles, not angles relative to the centre's sample. The still layer
/// is remembered, not averaged. The history is interpolated by a spline.
template <ChannelTag S> constexpr auto blur_paper(S signal, PathSearch search = {.iterations = 2}) {
    return Pipeline{signal,
                    Spatial{MotionGuide<>{}},
                    Spatial{SampleCollector<>{}},
                    Spatial{LayerSplit<S>{}},
                    Temporal{search, LayerBlend<S>{}, LayerFetch<S>{}},
                    Spatial{DirectionalAtrous<S>{}}};
}

/// blur_paper() without the pre-filter.
template <ChannelTag S> constexpr auto blur_no_pre_filter(S signal, PathSearch search = {.iterations = 2}) {
    return Pipeline{signal, Spatial{MotionGuide<>{}}, Spatial{LayerSplit<S>{}}, Temporal{search, LayerBlend<S>{}, LayerFetch<S>{}},
                    Spatial{DirectionalAtrous<S>{}}};
}

/// blur_wavelet() with an ordinary a-trous wavelet, whose taps do not follow the motion.
template <ChannelTag S> constexpr auto blur_fixed_step(S signal, PathSearch search = {}) {
    return blur_wavelet(signal, search, {.fixed_step = 1.f, .taps_across = 2});
}

/// Motion blur of a sharp picture of the middle of the open shutter, along each pixel's own velocity (GPU Gems 3, ch. 27).
constexpr auto gather_blur(auto signal, auto... options) { return Pipeline{signal, options..., Spatial{GatherBlur{}}}; }

/// Motion blur of a sharp picture of the middle of the open shutter, along the longest velocity around (McGuire et al. 2012).
constexpr auto tilemax_blur(auto signal, auto... options) { return Pipeline{signal, options..., Spatial{TileMaxBlur{}}}; }

/// All three effects of TRMV: direct * visibility + glossy + albedo * indirect.
template <class... Options> constexpr auto trmv_paper(Options... options) {
    return Composite{shadow_paper(Visibility{}, options...), glossy_paper(Glossy{}, options...), dual_cone_paper(Indirect{}, options...)};
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::presets
