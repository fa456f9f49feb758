#pragma once

#include <quell/blur/moving_and_static/motion_guide.hpp>

namespace quell {

/// How much a sample counts at a point that it passes: 1 on its path, falling to 0 in a distance of a pixel, or up to four where the motion
/// around varies (MB section 4.3); 0 where it passes while the shutter is closed.
struct PathWeight {
    using reads = Channels<GuideSpread>;
    float length_influence = 10.f; ///< beta_l of the paper
    float angle_influence = 1.f;   ///< beta_a of the paper
    float most = 1.f;              ///< by how much either variance widens the reach, at most

    /// The distance in which the weight falls to 0.
    template <class Px> QUELL_KERNEL auto reach(Px const& px) const {
        using Real = typename Px::Real;
        auto const spread = px[guide_spread];
        auto const by_length = 1.f + min(spread.x * length_influence, Real(most)),
                   by_angle = 1.f + min(spread.y * angle_influence, Real(most));
        return by_length * by_angle;
    }
    template <class Passing, class Real> QUELL_KERNEL static Real weight(Passing const& passing, Real reach) {
        return masked(passing.in_time(), max(1.f - passing.distance / reach, Real(0.f)));
    }
};

} // namespace quell
