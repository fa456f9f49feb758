#pragma once

#include <quell/frame/kept_channels.hpp>

/// @file
/// Contract of blur/: motion blur from one noisy sample per pixel, taken at a random time while the shutter is open (after MB). A sweep is
/// velocity times shutter time, in pixels. All passes share these steps:
///
///     signal, Depth, Sweep, Time
///       |
///       v   guide passes: how surfaces move around each pixel    trajectory/, two_motions/pair_guide.hpp
///       v   gather: two layers per pixel                         two_motions/pair_gather.hpp
///       |
///       |   ForegroundLayer, BackgroundLayer, ForegroundSweep, MeanSweep
///       v   Temporal: PathSearch finds the past; a fetch interpolates the history of each layer; a blend accumulates each
///       |             layer and composites them
///       v
///     blurred signal
namespace quell::inline QUELL_INSTRUCTION_SET {

/// Background layer: the signal, then the number of samples that it is the mean of.
template <ChannelTag Signal> struct BackgroundLayer : InternalChannel<Signal::components + 1> {
    static constexpr auto name = "background_layer";
    /// Sample counts of a static background that is seen, and of one that is guessed from neighbours.
    static constexpr float certain = 64.f, guessed = 0.05f;
};
/// Foreground layer: the signal times its coverage; the coverage, the share of the open shutter in which it hides the background, in [0,
/// 1]; and the number of samples that pass meanwhile, which is its sweep's length in pixels. History weighs the layer by that number.
template <ChannelTag Signal> struct ForegroundLayer : InternalChannel<Signal::components + 2> {
    static constexpr auto name = "foreground_layer";
};
/// Mean sweep of the foreground layer, in pixels. Both components are 4096 where there is no foreground.
struct ForegroundSweep : InternalChannel<2> {
    static constexpr auto name = "foreground_sweep";
};
/// The channel ForegroundSweep.
inline constexpr ForegroundSweep foreground_sweep;
/// Mean sweep of the background layer, in pixels.
struct MeanSweep : InternalChannel<2> {
    static constexpr auto name = "mean_sweep";
};
/// The channel MeanSweep.
inline constexpr MeanSweep mean_sweep;

namespace detail {
/// Appends a weight to a signal; signal_of and weight_of take them apart.
template <class V> QUELL_KERNEL auto layer_of(V const& signal, real_of<V> weight) {
    constexpr int n = components_of<V>;
    return make_value<n + 1, real_of<V>>([&](auto c) QUELL_INLINED {
        if constexpr (c < n)
            return component<c>(signal);
        else
            return weight;
    });
}
template <class L> QUELL_KERNEL auto signal_of(L const& layer) {
    return make_value<components_of<L> - 1, real_of<L>>([&](auto c) QUELL_INLINED { return component<c>(layer); });
}
template <class L> QUELL_KERNEL auto weight_of(L const& layer) { return component<components_of<L> - 1>(layer); }

/// Clamps the coverage to at most 1.
template <class L> QUELL_KERNEL L covering(L const& moving) { return layer_of(signal_of(moving), min(weight_of(moving), real_of<L>(1.f))); }
/// The moving layer composited over the static one. Where the static layer is unknown: the moving layer alone. Where both are: `otherwise`.
template <class L, class V> QUELL_KERNEL V layers_together(L const& moving, L const& still, V const& otherwise) {
    using Real = real_of<V>;
    auto const coverage = weight_of(moving), uncovered = 1.f - coverage;
    auto const over = add_scaled(signal_of(moving), signal_of(still), uncovered);
    auto const alone = scale(signal_of(moving), 1.f / max(coverage, Real(1e-6f)));
    auto const known = either(weight_of(still) > Real(0.f), uncovered < Real(1e-6f));
    return select(known, over, select(coverage > Real(1e-3f), alone, otherwise));
}
} // namespace detail

} // namespace quell::inline QUELL_INSTRUCTION_SET
