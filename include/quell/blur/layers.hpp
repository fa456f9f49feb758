#pragma once

#include <quell/frame/kept_channels.hpp>

namespace quell {

// The two layers of a picture with motion blur (MB section 3): what moves, and what stands still behind it.

/// What moves: the signal times how much of the open shutter it covers the pixel, and that coverage, in [0, 1].
template <ChannelTag Signal> struct MovingLayer : MadeChannel<Signal::components + 1> { static constexpr auto name = "moving_layer"; };
/// What stands still: the signal, and how far it is known: 1 where it was seen in the pixel itself, less where it was guessed from
/// neighbours, 0 where nothing is known of it.
template <ChannelTag Signal> struct StaticLayer : MadeChannel<Signal::components + 1> { static constexpr auto name = "static_layer"; };
/// What is behind: the signal, and how many samples it is the mean of; what stands still and is seen counts as many, what was guessed from
/// neighbours as a small part of one.
template <ChannelTag Signal> struct BackLayer : MadeChannel<Signal::components + 1> {
    static constexpr auto name = "back_layer";
    static constexpr float certain = 64.f, guessed = 0.05f;
};
/// The foreground layer: its signal times its coverage; its coverage, the part of the open shutter for which it hides the background, in
/// [0, 1]; and how many samples pass in that time, as many as it sweeps pixels, by which history weighs it.
template <ChannelTag Signal> struct FrontLayer : MadeChannel<Signal::components + 2> { static constexpr auto name = "front_layer"; };
/// The mean sweep of what is in front, in pixels; longer than any where nothing is.
struct FrontSweep : MadeChannel<2> {
    static constexpr auto name = "front_sweep";
};
inline constexpr FrontSweep front_sweep;
/// The moving layer behind the filters that history has nothing of.
template <ChannelTag Signal> struct FilteredLayer : MadeChannel<Signal::components + 1> { static constexpr auto name = "filtered_layer"; };
/// The mean sweep of the moving layer, in pixels; with two layers in motion, that of the background.
struct MeanSweep : MadeChannel<2> {
    static constexpr auto name = "mean_sweep";
};
inline constexpr MeanSweep mean_sweep;

namespace detail {
/// A layer's value from a signal and its weight, and back.
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

/// Whether something at a depth can't be seen here, since what is here stands still before it.
template <class Real> QUELL_KERNEL auto hidden_behind(Real depth, Real here, float tolerance) { return depth > here * (1.f + tolerance); }

/// A moving layer whose coverage is no more than all.
template <class L> QUELL_KERNEL L covering(L const& moving) { return layer_of(signal_of(moving), min(weight_of(moving), real_of<L>(1.f))); }
/// What moves over what stands still; where nothing is known of the latter, what moves alone, and where nothing is known at all,
/// `otherwise`.
template <class L, class V> QUELL_KERNEL V layers_together(L const& moving, L const& still, V const& otherwise) {
    using Real = real_of<V>;
    auto const coverage = weight_of(moving), uncovered = 1.f - coverage;
    auto const over = add_scaled(signal_of(moving), signal_of(still), uncovered);
    auto const alone = scale(signal_of(moving), 1.f / max(coverage, Real(1e-6f)));
    auto const known = either(weight_of(still) > Real(0.f), uncovered < Real(1e-6f));
    return select(known, over, select(coverage > Real(1e-3f), alone, otherwise));
}
} // namespace detail

} // namespace quell
