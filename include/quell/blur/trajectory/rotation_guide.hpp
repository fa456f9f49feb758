#pragma once

#include <quell/blur/trajectory/sample_trajectory.hpp>
#include <quell/filter/filter_kernel.hpp>
#include <quell/frame/cursor/taps.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Arcs whose bend a RotationGuide measures from Sweep, Time and Depth.
struct RotatingTrajectories {
    static constexpr bool bent = true; ///< trajectories have a bend
};

namespace detail {
/// Sums over neighbours of the same surface: how far the sweep's direction differs times the distance along the motion; and that distance,
/// squared. Their ratio is the rotation while the shutter is open.
struct RotationSums : InternalChannel<2> {
    static constexpr auto name = "rotation_sums";
};
inline constexpr RotationSums rotation_sums;

/// Whether two samples may be of the same, possibly rotating surface.
struct OneThing {
    float depth_gap, likeness;
    template <class Sample> QUELL_KERNEL auto operator()(Sample const& a, Sample const& b) const {
        using Real = decltype(a.time());
        auto const x = b.sweep().x - a.sweep().x, y = b.sweep().y - a.sweep().y;
        return both(b.known(), b.moves(), abs(b.inverse_depth() - a.inverse_depth()) < a.inverse_depth() * Real(depth_gap),
                    fma(x, x, y * y) < a.squared_length() * (likeness * likeness));
    }
};
struct TurnEvidenceOf {
    static constexpr auto name = "turn, evidence";
    static constexpr bool leaves_signal = true;
    using reads = Channels<SampleTrajectory<StraightTrajectories>>;
    using emits = Channels<RotationSums>;
    static constexpr float min_turn = 2e-3f; ///< about radians; less counts as no rotation
    static constexpr int radius = 1;
    OneThing one_thing;
    int step;

    constexpr int farthest_tap() const { return radius * step; }

    /// Regression of the sweep's direction over the position of the sweep's middle, with one term along the motion and one across it. Only
    /// the first is rotation: across the motion, directions differ without rotation, too.
    template <class Px> QUELL_KERNEL auto emit_channels(Px const& px) const {
        using Real = typename Px::Real;
        auto const own = usable_sample<StraightTrajectories>(px);
        auto const turnable = both(own.known(), own.moves());
        if (!any(turnable)) return emitted<Real>(rotation_sums, zero<vec2<Real>>());
        auto const v = own.sweep();
        auto const per_squared = own.time_per_pixel() * own.time_per_pixel();
        auto const until_middle = [](auto const& sample) QUELL_INLINED { return scale(sample.sweep(), Real(0.5f) - sample.time()); };
        auto const middle = until_middle(own);
        Real along_along(0.f), along_across(0.f), across_across(1e-3f), turned_along(0.f), turned_across(0.f);
        for_each_neighbour<radius>(px, step, [&](auto const& beside, auto inside, int dx, int dy) QUELL_INLINED {
            auto const other = usable_sample<StraightTrajectories>(beside);
            auto const weight = masked(one_thing(own, other), inside * per_squared);
            auto const m = until_middle(other);
            auto const x = m.x - middle.x + static_cast<float>(dx), y = m.y - middle.y + static_cast<float>(dy);
            auto const along = fma(x, v.x, y * v.y) * weight, across = fma(v.x, y, -(x * v.y)) * weight;
            auto const turned = fma(v.x, other.sweep().y, -(v.y * other.sweep().x)) * weight;
            along_along = fma(along, along, along_along);
            along_across = fma(along, across, along_across);
            across_across = fma(across, across, across_across);
            turned_along = fma(turned, along, turned_along);
            turned_across = fma(turned, across, turned_across);
        });
        auto const mixed = along_across / across_across;
        auto const spread = max(fma(-mixed, along_across, along_along), Real(0.f)), turned = fma(-mixed, turned_across, turned_along);
        // No rotation at all is cheap for TurningPathOf to find.
        auto const turns = both(turnable, abs(turned) > spread * Real(min_turn));
        return emitted<Real>(rotation_sums, vec2<Real>{masked(turns, turned), masked(turnable, spread)});
    }
};

struct TurningPathOf {
    static constexpr auto name = "turn, paths";
    static constexpr bool leaves_signal = true;
    using reads = Channels<SampleTrajectory<StraightTrajectories>, RotationSums>;
    using emits = Channels<SampleTrajectory<RotatingTrajectories>>;
    static constexpr int radius = 2;
    OneThing one_thing;
    int step;
    float min_evidence, min_bend;

    constexpr int farthest_tap() const { return radius * step; }

    template <class Px> QUELL_KERNEL auto emit_channels(Px const& px) const {
        using Real = typename Px::Real;
        auto const own = usable_sample<StraightTrajectories>(px);
        auto const turn = masked(both(own.known(), own.moves()), sagitta(px, own));
        auto const bent = turn * turn * own.squared_length() > Real(min_bend * min_bend);
        return emitted<Real>(SampleTrajectory<RotatingTrajectories>{}, make_value<6, Real>([&](auto c) QUELL_INLINED {
                                 if constexpr (c < 5)
                                     return component<c>(own.at);
                                 else
                                     return masked(bent, turn);
                             }));
    }

private:
    template <class Px, class Sample> QUELL_KERNEL auto sagitta(Px const& px, Sample const& own) const {
        using Real = typename Px::Real;
        auto turns = Real(0.f) > Real(0.f);
        for_each_neighbour<radius>(px, step, [&](auto const& beside, auto, int, int) QUELL_INLINED {
            turns = either(turns, beside[rotation_sums].x != Real(0.f));
        });
        if (!any(turns)) return Real(0.f);
        auto sums = zero<vec2<Real>>();
        for_each_neighbour<radius>(px, step, [&](auto const& beside, auto inside, int, int) QUELL_INLINED {
            sums = add_scaled(sums, beside[rotation_sums], masked(one_thing(own, usable_sample<StraightTrajectories>(beside)), inside));
        });
        // Sweeps are chords, so the slope is twice the sine of half the angle.
        auto const half_sine = clamp(sums.x / max(sums.y, Real(1e-9f)) * 0.5f, Real(-0.99f), Real(0.99f));
        return masked(sums.y > Real(min_evidence), half_sine * 0.5f / (sqrt(fma(-half_sine, half_sine, Real(1.f))) + 1.f));
    }
};
} // namespace detail

/// Measures how far trajectories bend, without help from the host. On a surface that rotates in the image plane, the direction of sweeps
/// changes along the motion; under pure translation it does not, however their lengths differ. Rotation is taken to be about the
/// instantaneous centre: the top of a rolling wheel bends twice as much as it should, and its hub, which moves straight, bends as well.
/// Emits SampleTrajectory<RotatingTrajectories>.
template <> struct PathGuide<RotatingTrajectories> {
    using reads = Channels<Depth, Sweep, Time>;
    using emits = Channels<SampleTrajectory<StraightTrajectories>, detail::RotationSums, SampleTrajectory<RotatingTrajectories>>;
    static constexpr bool leaves_signal = true;
    /// Spacing in pixels of the 3x3 samples that are compared, and of the 5x5 such comparisons that are summed.
    int near_step = 3, far_step = 9;
    float depth_gap = 0.1f;     ///< relative; largest difference of inverse depth within a surface
    float likeness = 0.7f;      ///< largest difference of two sweeps within a surface, relative to the pixel's own
    float min_evidence = 1e-3f; ///< least sum of the squared distances along the motion, in squared sweeps; below it nothing bends
    float min_bend = 0.05f;     ///< pixels; a trajectory that bends less is linear

    constexpr void for_each_pass(auto&& pass) const {
        detail::OneThing const one_thing{depth_gap, likeness};
        pass(detail::SampleTrajectoryOf<StraightTrajectories>{});
        pass(detail::TurnEvidenceOf{one_thing, near_step});
        pass(detail::TurningPathOf{one_thing, far_step, min_evidence, min_bend});
    }
};

/// The guide of RotatingTrajectories.
using RotationGuide = PathGuide<RotatingTrajectories>;

} // namespace quell::inline QUELL_INSTRUCTION_SET
