#pragma once

#include <quell/frame/cursor/pixel.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Depth difference per pixel along (dx, dy): the smaller in magnitude of the two one-sided differences. At a silhouette the larger one
/// crosses the edge. 0 where neither neighbour is a surface inside the image.
template <class Px> QUELL_KERNEL auto depth_slope(Px const& px, int dx, int dy) {
    using Real = typename Px::Real;
    auto const before = px.at(-dx, -dy), after = px.at(dx, dy);
    auto const z = px[depth], back = z - before[depth], forth = after[depth] - z;
    Real const none(3e38f);
    auto const size = [&](Real difference, auto inside)
                          QUELL_INLINED { return select(both(inside, is_finite(difference)), abs(difference), none); };
    auto const behind = size(back, before.inside()), ahead = size(forth, after.inside());
    return masked(min(behind, ahead) < none, select(behind < ahead, back, forth));
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
