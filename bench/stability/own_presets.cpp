#include "own_presets.hpp"

#include <denoise/denoiser_of.hpp>

namespace quell::stability {

using examples::preset;

examples::Preset shadow_without_falloff() {
    return preset("shadow-without-falloff", [] {
        using Forgetful = ForgetChanged<Exponential>;
        return Composite{
            Pipeline{visibility, Spatial{ShadowSplat{}}, Spatial{ChangeDetector<ShadowOrSurfaceMotion>{.levels = 1}},
                     Spatial{AdaptiveBilateral<PenumbraWidth>{.radius = 15}},
                     Temporal{FirstValid{SplattedShadowMotion{}, SurfaceMotion{}},
                              Clamped{WithCleanUp{Forgetful{{.alpha = 0.4f}, 2.f, 0.3f}}, MeanDeviation{.sigmas = 2.f}}, ShadowFetch{}},
                     Spatial{CleanUp<>{}}}};
    });
}

examples::Preset glossy_with_flat_mirror() {
    return preset("glossy-flat-mirror", [] {
        using Forgetful = ForgetChanged<RunningMean>;
        return Composite{Pipeline{glossy, Spatial{ChangeDetector<>{.levels = 1}},
                                  Temporal{FirstValid{ImageMotion{}, SurfaceMotion{}}, WithMoments{Forgetful{{.cap = 4.f}, 2.f, 0.3f}}},
                                  Spatial{VarianceGuidedAtrous<Product<DepthEdge, NormalEdge, LobeEdge>>{.levels = 4, .feedback = false}}}};
    });
}

examples::Preset svgf_without_fireflies() {
    return preset("svgf-suppress-fireflies", [] { return presets::svgf(radiance, Demodulate{}, SuppressFireflies{}); });
}

examples::Preset svgf_in_half() {
    return preset<Planar<Float16>>("svgf-half", [] { return presets::svgf(radiance, Demodulate{}); });
}

} // namespace quell::stability
