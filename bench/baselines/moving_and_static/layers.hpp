#pragma once

#include <quell/blur/layers.hpp>

// The layers of MB. MeanSweep is here the moving layer's.
namespace quell::inline QUELL_INSTRUCTION_SET {

/// Moving layer (MB section 3): the signal times its coverage, then the coverage: the share of the open shutter in which a moving surface
/// covers the pixel, in [0, 1].
template <ChannelTag Signal> struct MovingLayer : InternalChannel<Signal::components + 1> { static constexpr auto name = "moving_layer"; };
/// Static layer (MB section 3): the signal, then its confidence: 0 unknown, 1 seen. Between them it was guessed from neighbours; LayerSplit
/// gives the mean of static neighbours 1 as well.
template <ChannelTag Signal> struct StaticLayer : InternalChannel<Signal::components + 1> { static constexpr auto name = "static_layer"; };
/// The moving layer after the spatial filters behind Temporal. Not part of the history.
template <ChannelTag Signal> struct FilteredLayer : InternalChannel<Signal::components + 1> {
    static constexpr auto name = "filtered_layer";
};

namespace detail {
/// Whether a surface at `depth` is hidden by a static one at depth `here`.
template <class Real> QUELL_KERNEL auto hidden_behind(Real depth, Real here, float tolerance) { return depth > here * (1.f + tolerance); }
} // namespace detail

} // namespace quell::inline QUELL_INSTRUCTION_SET
