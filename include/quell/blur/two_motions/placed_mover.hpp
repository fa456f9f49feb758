#pragma once

#include <quell/blur/trajectory/usable_path.hpp>

namespace quell::detail {

/// A motion; with bends also its pixel coordinates, since a rotating surface has other velocities elsewhere.
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
/// The motion at another place of the same rigid surface, which rotates in the image plane.
template <class Paths, class Real>
QUELL_KERNEL Mover<Paths, Real> mover_at(PlacedMover<Paths, Real> const& placed, vec2<Real> const& place) {
    if constexpr (Paths::bent) {
        // Rotation about the instantaneous centre, to first order. The relative sagitta is the same everywhere.
        auto const turn = component<3>(placed) * 8.f;
        return {fma(component<5>(placed) - place.y, turn, component<0>(placed)),
                fma(place.x - component<4>(placed), turn, component<1>(placed)), component<2>(placed), component<3>(placed)};
    } else
        return placed;
}

} // namespace quell::detail
