#pragma once

#include <quell/blend/clamped.hpp>
#include <quell/blend/exponential.hpp>
#include <quell/blend/running_mean.hpp>
#include <quell/blend/with_moments.hpp>
#include <quell/filter/atrous.hpp>
#include <quell/filter/variance_guided_atrous.hpp>
#include <quell/motion/surface_motion.hpp>
#include <quell/pipeline/pipeline.hpp>

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

} // namespace quell::presets
