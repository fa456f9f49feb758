#pragma once

#include <quell/blend/clamped.hpp>
#include <quell/blend/exponential.hpp>
#include <quell/blend/running_mean.hpp>
#include <quell/blend/with_moments.hpp>
#include <quell/blend/with_variance.hpp>
#include <quell/filter/atrous.hpp>
#include <quell/filter/change/history_bias.hpp>
#include <quell/filter/conserving_atrous.hpp>
#include <quell/filter/local_regression.hpp>
#include <quell/filter/variance_guided_atrous.hpp>
#include <quell/motion/surface_motion.hpp>
#include <quell/pipeline/pipeline.hpp>

/// Ready pipelines, one line each, for any signal: presets::general(radiance, Demodulate{}). Extra parts go before the stages.
/// These want colour and guides: the signal, and what they read of albedo, normal, depth and motion.
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

} // namespace quell::presets
