#pragma once

#include <quell/blur/usable_path.hpp>

namespace quell::detail {

/// A mover, and where it is if its path bends: what turns moves otherwise beside it.
template <class Paths, class Real> using PlacedMover = Value<Paths::bent ? 7 : 3, Real>;
template <class Paths, class Px> QUELL_KERNEL auto placed_mover(Px const& px) {
    using Real = typename Px::Real;
    auto const mover = usable_sample<Paths>(px).mover();
    if constexpr (Paths::bent) {
        auto const place = px.position();
        return PlacedMover<Paths, Real>{
            {component<0>(mover), component<1>(mover), component<2>(mover), component<3>(mover), component<4>(mover), place.x, place.y}};
    } else
        return mover;
}
/// How what moves at one place moves at another, as a rigid thing that turns in the plane of the image.
template <class Paths, class Real>
QUELL_KERNEL Mover<Paths, Real> mover_at(PlacedMover<Paths, Real> const& placed, vec2<Real> const& place) {
    if constexpr (Paths::bent) {
        constexpr float most_turn = 3.f; // radians while the shutter is open; no path that bends evenly turns by more
        auto const v = speed_of(placed), bend = bend_of(placed);
        auto const per_squared = 1.f / max(squared_speed(placed), Real(still_squared));
        auto const turn = clamp(fma(v.y, bend.x, -(v.x * bend.y)) * per_squared * 8.f, Real(-most_turn), Real(most_turn));
        auto const x = fma(component<6>(placed) - place.y, turn, v.x), y = fma(place.x - component<5>(placed), turn, v.y);
        // Its bend turns and grows as its speed does.
        auto const along = fma(x, v.x, y * v.y) * per_squared, across = fma(y, v.x, -(x * v.y)) * per_squared;
        return Mover<Paths, Real>{{x, y, nearness_of(placed), fma(bend.x, along, -(bend.y * across)), fma(bend.y, along, bend.x * across)}};
    } else
        return placed;
}

} // namespace quell::detail
