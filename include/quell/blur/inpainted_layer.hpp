#pragma once

#include <quell/blur/layers.hpp>
#include <quell/frame/cursor/taps.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Fills in an unknown background layer: the mean of the 5x5 neighbours that show it, with the weight `certainty`; 0 where none does.
/// @param counts whether a neighbour shows the background. Not inlined: few pixels are covered.
template <class Px, class Counts> QUELL_OUTLINED constexpr auto inpainted_layer(Px const& px, float certainty, Counts const& counts) {
    using Real = typename Px::Real;
    auto sum = zero<typename Px::Signal>();
    Real weights(0.f);
    for_each_neighbour<2>(px, [&](auto neighbour, auto inside, int, int) QUELL_INLINED {
        auto const w = masked(counts(neighbour), inside);
        sum = add_scaled(sum, neighbour.signal(), w);
        weights = weights + w;
    });
    return layer_of(scale(sum, 1.f / max(weights, Real(1.f))), masked(weights > Real(0.f), Real(certainty)));
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
