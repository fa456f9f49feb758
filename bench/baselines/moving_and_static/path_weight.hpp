#pragma once

#include <baselines/moving_and_static/motion_guide.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Weight of a sample by its closest approach (MB section 4.3): 1 on its trajectory, falling linearly to 0 at a reach of 1 pixel, or up to
/// 4 where the velocities around vary; 0 where it passes while the shutter is closed.
struct PathWeight {
    using reads = Channels<GuideSpread>;
    static constexpr int farthest_tap = 0;
    float length_influence = 10.f; ///< beta_l of the paper
    float angle_influence = 1.f;   ///< beta_a of the paper
    float max_increase = 1.f;      ///< largest increase of the reach by each of the two variances: 1 doubles it

    /// Distance at which the weight is 0, in pixels.
    template <class Px> QUELL_KERNEL auto reach(Px const& px) const {
        using Real = typename Px::Real;
        auto const spread = px[guide_spread];
        auto const by_length = 1.f + min(spread.x * length_influence, Real(max_increase)),
                   by_angle = 1.f + min(spread.y * angle_influence, Real(max_increase));
        return by_length * by_angle;
    }
    /// @param passing Trajectory::ClosestApproach
    /// @param reach in pixels, above 0
    template <class ClosestApproach, class Real> QUELL_KERNEL static Real weight(ClosestApproach const& passing, Real reach) {
        return masked(passing.in_time(), max(1.f - passing.distance / reach, Real(0.f)));
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
