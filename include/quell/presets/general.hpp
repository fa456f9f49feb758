#pragma once

#include <quell/blend/clamped.hpp>
#include <quell/blend/exponential.hpp>
#include <quell/blend/running_mean.hpp>
#include <quell/blend/with_guides.hpp>
#include <quell/blend/with_moments.hpp>
#include <quell/blend/with_variance.hpp>
#include <quell/filter/atrous.hpp>
#include <quell/filter/change/history_bias.hpp>
#include <quell/filter/conserving_atrous.hpp>
#include <quell/filter/local_regression.hpp>
#include <quell/filter/variance_guided_atrous.hpp>
#include <quell/motion/surface_motion.hpp>
#include <quell/pipeline/pipeline.hpp>

/// Ready pipelines for any signal: `presets::general(radiance, Demodulate{})`. Further options go before the stages. The presets of this
/// file read the signal and guides (albedo, normal, depth, motion).
namespace quell::inline QUELL_INSTRUCTION_SET::presets {

/// The input as it is.
constexpr auto none(auto signal, auto... options) { return Pipeline{signal, options...}; }

/// Accumulation along surface motion vectors and nothing else: the baseline of all comparisons.
constexpr auto surface(auto signal, auto... options) {
    return Pipeline{signal, options..., Temporal{SurfaceMotion{}, Exponential{.alpha = 0.1f}}};
}

/// surface() with the history clamped to mean +- 1 sigma of the 3x3 around (Salvi 2015).
constexpr auto surface_clamp(auto signal, auto... options) {
    return Pipeline{signal, options..., Temporal{SurfaceMotion{}, Clamped{Exponential{.alpha = 0.1f}, MeanDeviation{.sigmas = 1.f}}}};
}

/// No history: an edge-avoiding a-trous wavelet of five levels (Dammertz 2010).
constexpr auto atrous(auto signal, auto... options) {
    return Pipeline{signal, options..., Spatial{Atrous{Product{DepthEdge{}, NormalEdge{}}}}};
}

/// Spatiotemporal variance-guided filtering (Schied et al. 2017). A cap of 5 frames is its alpha of 0.2.
constexpr auto svgf(auto signal, auto... options) {
    return Pipeline{signal, options..., Temporal{SurfaceMotion{}, WithMoments{RunningMean{.cap = 5.f}}},
                    Spatial{VarianceGuidedAtrous{Product{DepthEdge{}, NormalEdge{}}}}};
}

/// general() with numbers and a filter of your own. The history is long where nothing changes and short where measured light moves or
/// changes. The default filter is as wide as the remaining noise, for any number of samples, and loses no light.
/// @param accumulated how far the history is trusted
/// @param filter      the spatial filter: ConservingAtrous, LocalRegression, or another one that reads the variance
/// @param signal      the channel to denoise
/// @param options     further options of the Pipeline, such as Demodulate{}
constexpr auto general_with(ForgetBiased<RunningMean> accumulated, auto filter, auto signal, auto... options) {
    return Pipeline{signal, options..., Spatial{BiasEstimate<>{}}, Temporal{SurfaceMotion{}, WithVariance{accumulated}}, Spatial{filter}};
}

/// History of general() and final_frame().
inline constexpr ForgetBiased<RunningMean> general_history{.inner = {.cap = 24.f}, .gain = 100.f};

/// History for joining the frames before with the frames after (TwoSided): longer, since the errors of both sides partly cancel.
inline constexpr ForgetBiased<RunningMean> joined_history{.inner = {.cap = 48.f}, .gain = 30.f};

/// The preset to start with, for hosts with colour and guides: BiasEstimate, a RunningMean whose biased history is forgotten, and
/// ConservingAtrous.
constexpr auto general(auto signal, auto... options) { return general_with(general_history, ConservingAtrous<>{}, signal, options...); }

/// general() with joined_history: the second argument of TwoSided{}.
constexpr auto general_joining(auto signal, auto... options) {
    return general_with(joined_history, ConservingAtrous<>{}, signal, options...);
}

/// The filter of final_frame().
template <ChannelTag S> inline constexpr LocalRegression<Product<DepthEdge, NormalEdge>, S::components> final_frame_filter{};

/// general() for final frames, with a regression on the guides after its filter (LocalRegression): better, and slower.
template <class S> constexpr auto final_frame(S signal, auto... options) {
    if constexpr (ChannelTag<S>)
        return general_with(general_history, final_frame_filter<S>, signal, options...);
    else
        return Pipeline{signal, options...}; // which says that it must be one
}

/// final_frame() with joined_history: the second argument of TwoSided{}.
template <ChannelTag S> constexpr auto final_frame_joining(S signal, auto... options) {
    return general_with(joined_history, final_frame_filter<S>, signal, options...);
}

/// History of accumulated(). A network removes more noise than the wavelet of general() does, but no bias: less of that is accepted.
inline constexpr ForgetBiased<RunningMean> accumulated_history{.inner = {.cap = 24.f}, .gain = 1000.f};

/// general() up to its history, for a denoiser behind quell, such as a network: light as it was accumulated, multiplied by the albedo
/// again, and guides accumulated with it (WithGuides), which the history holds: `history[mean_albedo]`, `history[mean_normal]`.
constexpr auto accumulated(auto signal, auto... options) {
    return Pipeline{signal, options..., Spatial{BiasEstimate<>{}},
                    Temporal{SurfaceMotion{}, WithGuides{WithVariance{accumulated_history}}}};
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::presets
