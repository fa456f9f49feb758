#pragma once

#include <quell/blur/trajectory/sample_trajectory.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// A motion; with bends also its pixel coordinates, since a rotating surface has other velocities elsewhere.
template <class Trajectories, class Real> using PlacedMotion = Value<Trajectories::bent ? 6 : 3, Real>;
template <class Trajectories, class Px> QUELL_KERNEL auto placed_mover(Px const& px) {
    using Real = typename Px::Real;
    auto const screen_motion = usable_sample<Trajectories>(px).screen_motion();
    if constexpr (Trajectories::bent) {
        auto const place = px.position();
        return PlacedMotion<Trajectories, Real>{{component<0>(screen_motion), component<1>(screen_motion), component<2>(screen_motion),
                                                 component<3>(screen_motion), place.x, place.y}};
    } else
        return screen_motion;
}
/// The motion at another place of the same rigid surface, which rotates in the image plane.
template <class Trajectories, class Real>
QUELL_KERNEL ScreenMotion<Trajectories, Real> mover_at(PlacedMotion<Trajectories, Real> const& placed, vec2<Real> const& place) {
    if constexpr (Trajectories::bent) {
        // Rotation about the instantaneous centre, to first order. The relative sagitta is the same everywhere.
        auto const turn = component<3>(placed) * 8.f;
        return {fma(component<5>(placed) - place.y, turn, component<0>(placed)),
                fma(place.x - component<4>(placed), turn, component<1>(placed)), component<2>(placed), component<3>(placed)};
    } else
        return placed;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
