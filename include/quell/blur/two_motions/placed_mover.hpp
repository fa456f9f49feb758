#pragma once

#include <quell/blur/trajectory/usable_path.hpp>

namespace quell::detail {

/// A mover, and where it is if its path bends: what turns moves otherwise beside it.
template <class Paths, class Real> using PlacedMover = Value<Paths::bent ? 6 : 3, Real>;
template <class Paths, class Px> QUELL_KERNEL auto placed_mover(Px const& px) {
    using Real = typename Px::Real;
    auto const mover = usable_sample<Paths>(px).mover();
    if constexpr (Paths::bent) {
        auto const place = px.position();
        return PlacedMover<Paths, Real>{
            {component<0>(mover), component<1>(mover), component<2>(mover), component<3>(mover), place.x, place.y}};
    } else
        return mover;
}
/// How what moves at one place moves at another, as a rigid thing that turns in the plane of the image.
template <class Paths, class Real>
QUELL_KERNEL Mover<Paths, Real> mover_at(PlacedMover<Paths, Real> const& placed, vec2<Real> const& place) {
    if constexpr (Paths::bent) {
        // A circle's turn, to first order; its sagitta is the same everywhere.
        auto const turn = component<3>(placed) * 8.f;
        return {fma(component<5>(placed) - place.y, turn, component<0>(placed)),
                fma(place.x - component<4>(placed), turn, component<1>(placed)), component<2>(placed), component<3>(placed)};
    } else
        return placed;
}

} // namespace quell::detail
