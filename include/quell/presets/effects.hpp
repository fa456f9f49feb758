#pragma once

#include <quell/blend/clamped.hpp>
#include <quell/blend/exponential.hpp>
#include <quell/blend/non_planar_falloff.hpp>
#include <quell/blend/running_mean.hpp>
#include <quell/blend/with_clean_up.hpp>
#include <quell/blend/with_moments.hpp>
#include <quell/filter/bilateral.hpp>
#include <quell/filter/change/light_change.hpp>
#include <quell/filter/lobe_edge.hpp>
#include <quell/filter/shadow_splat.hpp>
#include <quell/filter/variance_guided_atrous.hpp>
#include <quell/motion/dual_motion.hpp>
#include <quell/motion/reflection/mirror_motion.hpp>
#include <quell/motion/reflection/thin_lens.hpp>
#include <quell/motion/surface_motion.hpp>
#include <quell/pipeline/composite.hpp>
#include <quell/radiance/cone_fetch.hpp>
#include <quell/radiance/cone_gather.hpp>
#include <quell/radiance/with_cones.hpp>

/// Presets for shadows, reflections and indirect light that move: each follows its effect by motion vectors of its own (Zeng et al. 2021),
/// and wants what these are made of: blockers, lights, hits and directions.
namespace quell::presets {

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

/// All effects, each by its own preset: direct * visibility + glossy + albedo * indirect.
template <class... Parts> constexpr auto trmv(Parts... parts) {
    return Composite{shadow(visibility, parts...), glossy(quell::glossy, parts...), dual_cone(indirect, parts...)};
}

} // namespace quell::presets
