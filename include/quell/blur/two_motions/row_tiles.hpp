#pragma once

#include <quell/blur/two_motions/pair_guide.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Tiles of a row whose pixels look along the same lines, so that a pack loads neighbours. A pack may span several tiles.
struct RowTiles {
    int width; ///< pixels, at least 1

    /// The pixel whose LayerMotions a pixel's tile shares.
    template <class Px> QUELL_KERNEL auto shared(Px const& px) const {
        using Real = typename Px::Real;
        auto const tile = floor(px.position().x / static_cast<float>(width));
        auto const column = fma(tile, Real(static_cast<float>(width)), Real(static_cast<float>(width / 2)));
        return PixelCoordinates<Real>(min(column, Real(to_real(px.size().width - 1))), Real(to_real(row_of_pair(px.y, px.size()))));
    }
    /// Calls visit(pixels, k) for each tile of a pack: the mask of its pixels, and the first one's lane. What is recorded is one pixel.
    template <class Px, class Visit> QUELL_KERNEL void for_each(Px const& px, Visit&& visit) const {
        using Real = typename Px::Real;
        auto const column = px.columns();
        if constexpr (records<Real>)
            visit(column <= column, 0);
        else
            for (int first = px.x; first < px.x + Px::pack_width;) {
                int const next = (first / width + 1) * width;
                visit(both(column >= Real(static_cast<float>(first)), column < Real(static_cast<float>(next))), first - px.x);
                first = next;
            }
    }
};

/// What lane() gives.
template <class Real> using LaneOf = decltype(lane(std::declval<Real>(), 0));
/// A vector of one lane.
template <class Real> QUELL_KERNEL vec2<LaneOf<Real>> in_lane(vec2<Real> const& v, int k) { return {lane(v.x, k), lane(v.y, k)}; }

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
