#pragma once

#include <quell/blur/two_motions/pair_gather.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Mean of each layer along its own motion, over the gaps that PairGather leaves. Where a sweep is longer than PairGather has samples for,
/// pixels next to each other along the motion gather other samples: their mean has the noise of them all. A blurred layer changes slowly
/// along its motion, so little is lost, as long as the mean's length is a small part of the sweep's. Neighbours count by how like their
/// sweep is. What stands still keeps its value bit by bit. Goes directly after the PairGather, and has its settings.
/// @tparam S the pipeline's signal
/// @tparam Trajectories the PairGather's
template <ChannelTag S, class Trajectories> struct DirectionalMean {
    using Signal = S;
    using Gather = PairGather<S, Trajectories>; ///< what it goes after
    static constexpr auto name = "directional mean";
    static constexpr bool leaves_signal = true;
    static constexpr int max_lanes = Gather::max_lanes; ///< largest useful SIMD width: a tile's
    static constexpr bool two_rows = Gather::two_rows;  ///< as there
    using reads = Channels<LayerMotions<Trajectories>, ForegroundLayer<Signal>, ForegroundSweep, BackgroundLayer<Signal>, MeanSweep>;
    using emits = Channels<ForegroundLayer<Signal>, BackgroundLayer<Signal>>;
    Gather gather{};        ///< whose gaps it fills
    float gaps = 2.f;       ///< length of the mean, in gaps between samples
    float max_part = 0.12f; ///< largest length of the mean, as a fraction of the sweep
    int taps = 6;           ///< neighbours to either side, at most
    float tolerance =
        0.25f; ///< difference of sweeps from which on a neighbour counts nothing, as a fraction of the sweep, beyond half a pixel

    template <class Px> QUELL_KERNEL auto emit_channels(Px const& px) const {
        using Real = typename Px::Real;
        constexpr ForegroundLayer<Signal> front;
        constexpr BackgroundLayer<Signal> back;
        auto in_front = px[front];
        auto behind = px[back];
        detail::LayerClassifier<Trajectories, Real> const of(px.elsewhere(gather.tiles().shared(px), LayerMotions<Trajectories>{}));
        gather.tiles().for_each(px, [&](auto tile, int k) QUELL_INLINED {
            auto const speed_in_front = detail::in_lane(detail::speed_of(of.front), k);
            auto const speed_behind = detail::in_lane(detail::speed_of(of.back), k);
            using Lane = detail::LaneOf<Real>;
            auto const two = lane(detail::inverse_depth_of(of.front), k) > Lane(0.f),
                       moves = dot(speed_behind, speed_behind) > Lane(detail::still_squared), shared = both(two, moves);
            if (any(two)) average(px, front, foreground_sweep, speed_in_front, two, shared, tile, in_front);
            if (any(moves)) average(px, back, mean_sweep, speed_behind, moves, shared, tile, behind);
        });
        return emitted<Real>(front, in_front).with(back, behind);
    }

private:
    /// Replaces the layer of a tile by its mean along the velocity `speed`. Number of samples stays: history weighs by it.
    /// @param wanted whether the tile has the layer @param shared whether two lines share its samples
    template <class Px, class Layer, class SweepChannel, class Lane, class LaneMask, class Mask, class V>
    QUELL_KERNEL void average(Px const& px, Layer layer, SweepChannel of_layer, vec2<Lane> const& speed, LaneMask wanted, LaneMask shared,
                              Mask tile, V& value) const {
        using Real = typename Px::Real;
        auto const line = gather.line(speed, vec2<Lane>{Lane(0.f), Lane(0.f)}, shared);
        auto const length = min(line.step * gaps, line.whole * max_part);
        auto const spacing = max(length / static_cast<float>(2 * taps + 1), Lane(1.f));
        auto const each_side = masked(wanted, min(Lane(static_cast<float>(taps)), floor(0.5f * length / spacing)));
        if (!any(each_side > Lane(0.f))) return;
        auto const own = px[of_layer];
        auto const likeness = 1.f / fma(sqrt(fma(own.x, own.x, own.y * own.y)), Real(tolerance), Real(0.5f));
        auto const samples = samples_of(layer, value);
        auto sum = scale(value, samples);
        auto weights = samples;
        auto const add_neighbour = [&](Lane turn) QUELL_INLINED {
            auto const i = turn - each_side;
            auto const offset = line.nearest(select(i < Lane(0.f), i, i + 1.f) * spacing);
            auto const there = px.at(offset.x, offset.y);
            if (!there.any_row_inside()) return;
            auto const its = there[layer];
            auto const x = there[of_layer].x - own.x, y = there[of_layer].y - own.y;
            auto const alike = clamp(fma(sqrt(fma(x, x, y * y)) * likeness, Real(-2.f), Real(2.f)), Real(0.f), Real(1.f));
            auto const w = masked(there.inside(), alike * samples_of(layer, its));
            sum = add_scaled(sum, its, w);
            weights = weights + w;
        };
        for_each_turn(2.f * each_side, add_neighbour, sum, weights);
        auto const mean = scale(sum, 1.f / max(weights, Real(1e-30f)));
        value = select(both(tile, weights > samples), detail::layer_of(detail::signal_of(mean), detail::weight_of(value)), value);
    }
    /// The background's mean is weighted by samples. The foreground has as many everywhere: its coverage is a share of all that pass.
    template <class V> QUELL_KERNEL static auto samples_of(BackgroundLayer<Signal>, V const& layer) { return detail::weight_of(layer); }
    template <class V> QUELL_KERNEL static auto samples_of(ForegroundLayer<Signal>, V const&) { return real_of<V>(1.f); }
};
template <class S, class Trajectories, class... Fields>
DirectionalMean(PairGather<S, Trajectories>, Fields...) -> DirectionalMean<S, Trajectories>;

} // namespace quell::inline QUELL_INSTRUCTION_SET
