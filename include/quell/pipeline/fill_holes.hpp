#pragma once

#include <quell/frame/cursor/taps.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Gives missing samples without a usable neighbour the mean of what stands around them, `step` pixels apart. Passes of 2, 4, 8, ... pixels
/// after the ingest, which looks at the 3x3 around, reach all of the image. Frames without such holes have none of these passes. Where a
/// frame has no usable sample at all, what the history has in the same pixel stands in.
struct FillHoles {
    static constexpr auto name = "fill holes";
    static constexpr bool reads_past_signal = true;
    int step; ///< 0: from the history

    constexpr int farthest_tap() const { return step; }

    QUELL_KERNEL auto operator()(auto px) const {
        using Px = decltype(px);
        using Real = typename Px::Real;
        using Mark = typename Px::Scope::mark;
        auto const stored = px.stored_signal();
        auto const hole = Mark::hole(stored);
        if (!any(hole)) return stored;
        if (step == 0) {
            PixelCoordinates<Real> const here(px.columns(), px.row_of_lanes());
            return select(hole, Mark::marked(px.past(here).signal(), hole), stored);
        }
        auto sum = zero<typename Px::Signal>();
        Real weights(0.f);
        for_each_neighbour<1>(px, step, [&](auto const& neighbour, auto inside, int, int) QUELL_INLINED {
            auto const there = neighbour.stored_signal();
            auto const w = masked(invert(Mark::hole(there)), inside);
            sum = add_scaled(sum, Mark::value(there), w);
            weights = weights + w;
        });
        auto const filled = both(hole, weights > Real(0.f));
        return select(filled, Mark::marked(scale(sum, 1.f / max(weights, Real(1.f))), filled), stored);
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
