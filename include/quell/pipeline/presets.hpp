#pragma once

#include <quell/blend/clamped.hpp>
#include <quell/blend/exponential.hpp>
#include <quell/blend/non_planar_falloff.hpp>
#include <quell/blend/running_mean.hpp>
#include <quell/blend/with_clean_up.hpp>
#include <quell/blend/with_moments.hpp>
#include <quell/blend/with_variance.hpp>
#include <quell/blur/directional_atrous.hpp>
#include <quell/blur/gather_blur.hpp>
#include <quell/blur/layer_history.hpp>
#include <quell/blur/layer_split.hpp>
#include <quell/blur/pair_history.hpp>
#include <quell/blur/path_gather.hpp>
#include <quell/blur/path_search.hpp>
#include <quell/blur/sample_collector.hpp>
#include <quell/blur/tile_max_blur.hpp>
#include <quell/filter/atrous.hpp>
#include <quell/filter/bilateral.hpp>
#include <quell/filter/conserving_atrous.hpp>
#include <quell/filter/history_bias.hpp>
#include <quell/filter/light_change.hpp>
#include <quell/filter/lobe_edge.hpp>
#include <quell/filter/local_regression.hpp>
#include <quell/filter/shadow_splat.hpp>
#include <quell/filter/temporal_gradient.hpp>
#include <quell/filter/variance_guided_atrous.hpp>
#include <quell/motion/dual_motion.hpp>
#include <quell/motion/glossy_motion.hpp>
#include <quell/motion/surface_motion.hpp>
#include <quell/motion/thin_lens.hpp>
#include <quell/pipeline/composite.hpp>
#include <quell/pipeline/pipeline.hpp>
#include <quell/radiance/cone_atrous.hpp>
#include <quell/radiance/cone_fetch.hpp>
#include <quell/radiance/cone_gather.hpp>
#include <quell/radiance/with_cones.hpp>

/// Ready pipelines, one line each, for any signal: presets::svgf(radiance, Demodulate{}). Extra parts go before the stages.
namespace quell::presets {

/// The input as it is.
constexpr auto none(ChannelTag auto signal, auto... parts) { return Pipeline{signal, parts...}; }
/// History along the surface, nothing else: what every other preset is measured against.
constexpr auto surface(ChannelTag auto signal, auto... parts) {
    return Pipeline{signal, parts..., Temporal{SurfaceMotion{}, Exponential{.alpha = 0.1f}}};
}
/// The same with the history clamped to mean +- 1 sigma of the 3x3 around (Salvi 2015).
constexpr auto surface_clamp(ChannelTag auto signal, auto... parts) {
    return Pipeline{signal, parts..., Temporal{SurfaceMotion{}, Clamped{Exponential{.alpha = 0.1f}, MeanDeviation{.sigmas = 1.f}}}};
}
/// Space only: a five-level edge-avoiding wavelet (Dammertz 2010).
constexpr auto atrous(ChannelTag auto signal, auto... parts) {
    return Pipeline{signal, parts..., Spatial{Atrous{Product{DepthEdge{}, NormalEdge{}}}}};
}
/// Spatiotemporal variance-guided filtering (Schied 2017); a cap of 5 frames is its alpha of 0.2.
constexpr auto svgf(ChannelTag auto signal, auto... parts) {
    return Pipeline{signal, parts..., Temporal{SurfaceMotion{}, WithMoments{RunningMean{.cap = 5.f}}},
                    Spatial{VarianceGuidedAtrous{Product{DepthEdge{}, NormalEdge{}}}}};
}

/// For what every host has: colour and guides. History is long where nothing changes and short where light moves or changes by itself,
/// which is measured; the filter is as wide as the noise that is left, for any number of samples; and no light is lost.
/// @param accumulated how far history is trusted
/// @param filter      the filter over space
constexpr auto general_with(ForgetBiased<RunningMean> accumulated, auto filter, ChannelTag auto signal, auto... parts) {
    return Pipeline{signal, parts..., Spatial{BiasEstimate<>{}}, Temporal{SurfaceMotion{}, WithVariance{accumulated}}, Spatial{filter}};
}
inline constexpr ForgetBiased<RunningMean> general_history{.inner = {.cap = 24.f}, .gain = 100.f};
/// For joining the frames before with the frames after (run_two_sided): what the two get wrong cancels in part.
inline constexpr ForgetBiased<RunningMean> joined_history{.inner = {.cap = 48.f}, .gain = 30.f};
constexpr auto general(ChannelTag auto signal, auto... parts) {
    return general_with(general_history, ConservingAtrous<>{}, signal, parts...);
}
constexpr auto general_joining(ChannelTag auto signal, auto... parts) {
    return general_with(joined_history, ConservingAtrous<>{}, signal, parts...);
}
/// general for final frames, where nobody waits: a regression on the guides follows its filter.
constexpr auto final_frame(ChannelTag auto signal, auto... parts) {
    return general_with(general_history, LocalRegression<>{}, signal, parts...);
}
constexpr auto final_frame_joining(ChannelTag auto signal, auto... parts) {
    return general_with(joined_history, LocalRegression<>{}, signal, parts...);
}
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

/// Shadows, with history that follows them (TRMV section 4.1): visibility filtered as wide as its penumbra, then accumulated. A
/// narrower filter, a shorter history and a tighter clamp than the paper's, which shadow_paper has, history that is forgotten where samples
/// contradict it together, and a sharper fetch, which thin shadows need: less error on fence, fence-lights, apples, pinkroom and
/// thinshadows (quell-chart).
constexpr auto shadow(ChannelTag auto signal, auto... parts) {
    constexpr ForgetChanged<Exponential> accumulated{.inner = {.alpha = 0.4f}, .by_chance = 2.f, .sharpness = 0.3f};
    return Pipeline{signal,
                    parts...,
                    Spatial{ShadowSplat{}},
                    Spatial{ChangeDetector<ShadowOrSurfaceMotion>{.levels = 1}},
                    Spatial{AdaptiveBilateral<PenumbraWidth>{.radius = 15}},
                    Temporal{FirstValid{SplattedShadowMotion{}, SurfaceMotion{}},
                             Clamped{WithCleanUp{NonPlanarFalloff{accumulated}}, MeanDeviation{.sigmas = 2.f}}, ShadowFetch{}},
                    Spatial{CleanUp<>{}}};
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
/// Glossy reflections, with history that follows the virtual image, in curved mirrors too (TRMV sections 4.2 and 7), then a variance-guided
/// filter as wide as the lobe. History is short, and shorter where samples contradict it together: one vector a pixel can't follow all that
/// a rough lobe shows. glossy_paper draws its vectors from the lobe.
/// @tparam Mirror where the virtual image lies: FlatMirror or ThinLens
template <class Mirror = ThinLens> constexpr auto glossy(ChannelTag auto signal, auto... parts) {
    constexpr ForgetChanged<RunningMean> accumulated{.inner = {.cap = 4.f}, .by_chance = 2.f, .sharpness = 0.3f};
    return Pipeline{signal, parts..., Spatial{ChangeDetector<>{.levels = 1}},
                    Temporal{FirstValid{ImageMotion{Mirror{}}, SurfaceMotion{}}, WithMoments{accumulated}},
                    Spatial{VarianceGuidedAtrous<Product<DepthEdge, NormalEdge, LobeEdge>>{.levels = 4, .feedback = false}}};
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
/// The same with history as incident radiance in six cones, so that what was seen on a surface of another direction serves as well. Cones
/// are added up over the 3x3 around, and what they shade to is filtered as a colour: as good as filtering them all the way, which
/// dual_cone_paper does, and several times as fast. Where light changes by itself its long history is forgotten at once.
constexpr auto dual_cone(ChannelTag auto signal, auto... parts) {
    return Pipeline{signal,
                    parts...,
                    Spatial{ChangeDetector<>{}},
                    Temporal{FirstValid{SurfaceMotion{}, DualMotion<>{.trust = 0.25f}},
                             WithCones{WithMoments{ForgetChanged{RunningMean{.cap = 24.f}}}}, ConeFetch{}},
                    Spatial{ConeGather{}},
                    Spatial{VarianceGuidedAtrous<>{.edge = {DepthEdge{}, NormalEdge{.sharpness = 32.f}},
                                                   .levels = 3,
                                                   .sigma_luminance = 4.f,
                                                   .feedback = false,
                                                   .first_step = 2}}};
}
constexpr auto dual_cone_paper(ChannelTag auto signal, auto... parts) {
    return Pipeline{signal, Cones{}, parts..., Temporal{FirstValid{SurfaceMotion{}, DualMotion{}}, RunningMean{.cap = 32.f}, ConeFetch{}},
                    Spatial{ConeAtrous<Product<DepthEdge, NormalEdge>>{.least_cosine = 0.9f}}};
}
/// Motion blur from one sample per pixel at a random time (after Oberberger et al. 2022): samples are gathered along the two motions that
/// meet around a pixel, tested by their own paths one by one, and what is in front and what is behind are each accumulated over frames.
/// @tparam Paths TurningPaths: what turns is blurred along arcs, which are measured; BentPaths: arcs that the host supplies; or
/// StraightPaths, which cost less
/// @param search how the past is found. How long the shutter is open each frame says: frame.shutter
template <class Paths = TurningPaths, class Footprint = FixedFootprint, ChannelTag S>
constexpr auto blur(S signal, PathSearch search = {}, PairGather<S, Paths, Footprint> gather = {}) {
    return Pipeline{signal, Spatial{PairGuide<Paths>{}}, Spatial{gather},
                    Temporal{search, PairBlend<S>{}, PairFetch<S>{search.along(front_sweep)}}};
}
/// blur where shadows and reflections don't move like the surfaces that show them: each along sweeps of its own (the way out that MB
/// section 6 names). direct * visibility + glossy + albedo * indirect, all of them blurred, along straight lines.
template <class = void> constexpr auto blur_split(PathSearch search = {}) {
    return Composite{blur<StraightPathsAlong<SweepOf<Visibility>>>(visibility, search),
                     blur<StraightPathsAlong<SweepOf<Glossy>>>(quell::glossy, search), blur<StraightPaths>(direct, search),
                     blur<StraightPaths>(indirect, search), blur<StraightPaths>(albedo, search)};
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
/// All effects, each by its own preset: direct * visibility + glossy + albedo * indirect.
template <class... Parts> constexpr auto trmv(Parts... parts) {
    return Composite{shadow(visibility, parts...), glossy(quell::glossy, parts...), dual_cone(indirect, parts...)};
}
template <class... Parts> constexpr auto trmv_paper(Parts... parts) {
    return Composite{shadow_paper(visibility, parts...), glossy_paper(quell::glossy, parts...), dual_cone_paper(indirect, parts...)};
}

} // namespace quell::presets
