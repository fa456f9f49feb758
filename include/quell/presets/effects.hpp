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

/// Presets for moving shadows, reflections and indirect light. Each effect has motion vectors of its own (Zeng et al. 2021), and reads what
/// these are computed from: blockers, lights, hits and directions. A preset of one effect takes the effect's own channel where none is
/// given.
namespace quell::inline QUELL_INSTRUCTION_SET::presets {

/// Shadows with motion vectors of their own (TRMV section 4.1). Visibility is filtered by the width of its penumbra, then accumulated.
/// Compared with the paper: a narrower filter, a shorter history, a tighter clamp, history that is forgotten where the light changes,
/// and a sharper fetch, which thin shadows need.
template <class S = Visibility> constexpr auto shadow(S signal = {}, auto... options) {
    constexpr ForgetChanged<Exponential> accumulated{.inner = {.alpha = 0.4f}, .noise_threshold = 2.f, .sharpness = 0.3f};
    return Pipeline{signal,
                    options...,
                    Spatial{ShadowSplat{}},
                    Spatial{ChangeDetector<ShadowOrSurfaceMotion>{.levels = 1}},
                    Spatial{AdaptiveBilateral<PenumbraWidth>{.radius = 15}},
                    Temporal{FirstValid{SplattedShadowMotion{}, SurfaceMotion{}},
                             Clamped{WithCleanUp{NonPlanarFalloff{accumulated}}, MeanDeviation{.sigmas = 2.f}}, ShadowFetch{}},
                    Spatial{CleanUp<>{}}};
}

/// Glossy reflections whose history follows the virtual image, in curved mirrors too (TRMV sections 4.2 and 7). A variance-guided filter as
/// wide as the GGX lobe follows. The history is short, and shorter where the light changes: one motion vector per pixel cannot follow all
/// that a rough lobe shows. Its variance comes from few frames and is often too small, so more is tolerated than in svgf.
/// @tparam Mirror where the virtual image lies: FlatMirror or ThinLens
template <class Mirror = ThinLens, class S = Glossy> constexpr auto glossy(S signal = {}, auto... options) {
    constexpr ForgetChanged<RunningMean> accumulated{.inner = {.cap = 4.f}, .noise_threshold = 2.f, .sharpness = 0.3f};
    return Pipeline{signal, options..., Spatial{ChangeDetector<>{.levels = 1}},
                    Temporal{FirstValid{ImageMotion{Mirror{}}, SurfaceMotion{}}, WithMoments{accumulated}},
                    Spatial{VarianceGuidedAtrous<Product<DepthEdge, NormalEdge, LobeEdge>, LinearThenBox>{
                        .levels = 3, .sigma_luminance = 4.f, .feedback = false}}};
}

/// Diffuse indirect light whose history is incident radiance in six cones (TRMV section 4.3), so that history of a surface with another
/// normal serves too, and is forgotten where the light changes. Cones are added over the 3x3 around. The colour that they shade to is
/// filtered, which costs less than filtering cones. The first level tolerates most: the variance of short histories is often too small.
template <class S = Indirect> constexpr auto dual_cone(S signal = {}, auto... options) {
    constexpr VarianceGuidedAtrous<Product<DepthEdge, NormalEdge>, LinearThenBox> filter{
        .edge = {DepthEdge{}, NormalEdge{.sharpness = 32.f}},
        .levels = 3,
        .sigma_luminance = 2.f,
        .feedback = false,
        .first_step = 2,
        .first_tolerance = 4.f};
    return Pipeline{signal,
                    options...,
                    Spatial{ChangeDetector<>{}},
                    Temporal{FirstValid{SurfaceMotion{}, DualMotion<>{.trust = 0.25f}},
                             WithCones{WithMoments{ForgetChanged{RunningMean{.cap = 24.f}}}}, ConeFetch{}},
                    Spatial{ConeGather{}},
                    Spatial{filter}};
}

/// All three: direct * visibility + glossy + albedo * indirect.
template <class... Options> constexpr auto trmv(Options... options) {
    return Composite{shadow(Visibility{}, options...), glossy(Glossy{}, options...), dual_cone(Indirect{}, options...)};
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::presets
