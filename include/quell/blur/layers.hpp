#pragma once

#include <quell/frame/kept_channels.hpp>

/// @file
/// Contract of blur/: motion blur from one noisy sample per pixel, taken at a random time while the shutter is open (after MB). A sweep is
/// velocity times shutter time, in pixels. All passes share these steps:
///
///     signal, Depth, Sweep, Time
///       |
///       v   guide passes: how surfaces move around each pixel    trajectory/, two_motions/pair_guide.hpp,
///       |                                                        moving_and_static/motion_guide.hpp
///       v   gather or split: two layers per pixel                two_motions/pair_gather.hpp, moving_and_static/
///       |
///       |   ForegroundLayer, BackgroundLayer, ForegroundSweep, MeanSweep         two velocities: foreground and background layer
///       |   MovingLayer, StaticLayer, MeanSweep                  one velocity: moving and static layer
///       v   Temporal: PathSearch finds the past; a fetch interpolates the history of each layer; a blend accumulates each
///       |             layer and composites them
///       v
///     blurred signal
///
/// Post-process blurs (post_process/) are baselines without layers: they blur a sharp picture.
namespace quell::inline QUELL_INSTRUCTION_SET {

/// Moving layer (MB section 3): the signal times its coverage, then the coverage: the share of the open shutter in which a moving surface
/// covers the pixel, in [0, 1].
template <ChannelTag Signal> struct MovingLayer : InternalChannel<Signal::components + 1> { static constexpr auto name = "moving_layer"; };
/// Static layer (MB section 3): the signal, then its confidence: 0 unknown, 1 seen. Between them it was guessed from neighbours; LayerSplit
/// gives the mean of static neighbours 1 as well.
template <ChannelTag Signal> struct StaticLayer : InternalChannel<Signal::components + 1> { static constexpr auto name = "static_layer"; };
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
/// The moving layer after the spatial filters behind Temporal. Not part of the history.
template <ChannelTag Signal> struct FilteredLayer : InternalChannel<Signal::components + 1> {
    static constexpr auto name = "filtered_layer";
};
/// Mean sweep of the moving layer, in pixels; with two velocities, that of the background layer.
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

/// Whether a surface at `depth` is hidden by a static one at depth `here`.
template <class Real> QUELL_KERNEL auto hidden_behind(Real depth, Real here, float tolerance) { return depth > here * (1.f + tolerance); }

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
