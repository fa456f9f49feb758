#pragma once

#include <quell/blur/trajectory/trajectory.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Trajectory of each pixel's sample, made safe to use. Components: sweep x and y (pixels; 0 if static); sample time in [0, 1]; inverse
/// depth; time to cross a pixel, as a fraction of the open shutter (0 for a missing sample, 2 if static). With bends also the relative
/// sagitta: distance from the sweep's middle to the trajectory's, divided by the sweep's length, positive towards (sweep.y, -sweep.x). The
/// bend's part along the sweep, a change of speed, is dropped.
/// @tparam Trajectories StraightTrajectories, BentTrajectories or RotatingTrajectories
template <class Trajectories> struct SampleTrajectory : InternalChannel<Trajectories::bent ? 6 : 5> {
    static constexpr auto name = "sample_trajectory";
};

namespace detail {

/// Velocity (pixels per open shutter), inverse depth, and relative sagitta with bends: the features that tell surfaces apart.
template <class Trajectories, class Real> using ScreenMotion = Value<Trajectories::bent ? 4 : 3, Real>;
/// Squared length of a sweep in pixels, up to which it is static.
inline constexpr float still_squared = Trajectory<float>::min_length * Trajectory<float>::min_length;

template <class M> QUELL_KERNEL auto speed_of(M const& screen_motion) {
    return vec2<real_of<M>>{component<0>(screen_motion), component<1>(screen_motion)};
}
template <class M> QUELL_KERNEL auto inverse_depth_of(M const& screen_motion) { return component<2>(screen_motion); }
template <class M> QUELL_KERNEL auto sagitta_of([[maybe_unused]] M const& screen_motion) {
    if constexpr (3 < components_of<M>)
        return component<3>(screen_motion);
    else
        return real_of<M>(0.f);
}
/// The bend in pixels.
template <class M> QUELL_KERNEL auto bend_of(M const& screen_motion) {
    auto const s = sagitta_of(screen_motion);
    return vec2<real_of<M>>{component<1>(screen_motion) * s, -(component<0>(screen_motion) * s)};
}
template <class M> QUELL_KERNEL auto squared_speed(M const& screen_motion) {
    return fma(component<0>(screen_motion), component<0>(screen_motion), component<1>(screen_motion) * component<1>(screen_motion));
}
/// Squared difference of two velocities.
template <class M> QUELL_KERNEL auto squared_difference(M const& a, M const& b) {
    auto const x = component<0>(a) - component<0>(b), y = component<1>(a) - component<1>(b);
    return fma(x, x, y * y);
}

/// Access to a value of SampleTrajectory.
template <class Trajectories, class Real> struct UsableSample {
    Value<SampleTrajectory<Trajectories>::components, Real> at;

    /// The same with another model: with its sagitta, or without.
    template <class As> QUELL_KERNEL UsableSample<As, Real> as() const {
        if constexpr (As::bent == Trajectories::bent)
            return {at};
        else
            return {{component<0>(at), component<1>(at), component<2>(at), component<3>(at), component<4>(at)}};
    }
    /// The same with a sagitta of 0 where `bends` is false.
    QUELL_KERNEL UsableSample bent_where(auto bends) const {
        return {{component<0>(at), component<1>(at), component<2>(at), component<3>(at), component<4>(at), masked(bends, sagitta())}};
    }
    QUELL_KERNEL vec2<Real> sweep() const { return {component<0>(at), component<1>(at)}; }
    QUELL_KERNEL Real time() const { return component<2>(at); }
    QUELL_KERNEL Real inverse_depth() const { return component<3>(at); }
    QUELL_KERNEL Real time_per_pixel() const { return component<4>(at); }
    QUELL_KERNEL Real squared_length() const { return fma(sweep().x, sweep().x, sweep().y * sweep().y); }
    /// Length of the sweep in pixels; 0 if static.
    QUELL_KERNEL Real length() const { return squared_length() * time_per_pixel(); }
    QUELL_KERNEL auto moves() const { return time_per_pixel() < Real(1.f / Trajectory<Real>::min_length); }
    QUELL_KERNEL auto known() const { return time_per_pixel() > Real(0.f); }
    /// Closest approach; `offset` is the point minus the sample's pixel.
    QUELL_KERNEL typename Trajectory<Real>::ClosestApproach passing(vec2<Real> const& offset) const {
        auto const moving = passing_in_motion(offset);
        return {select(moves(), moving.distance, sqrt(fma(offset.x, offset.x, offset.y * offset.y))), moving.when};
    }
    /// The same for a sample that is known to move. An arc is evaluated where the point projects onto the sweep: points that count are so
    /// near that its closest approach is hardly earlier or later.
    QUELL_KERNEL typename Trajectory<Real>::ClosestApproach passing_in_motion(vec2<Real> const& offset) const {
        auto const v = sweep();
        auto const along = fma(offset.x, v.x, offset.y * v.y) * time_per_pixel() * time_per_pixel(), when = time() + along;
        auto const aside = fma(offset.x, v.y, -(offset.y * v.x)) * time_per_pixel();
        if constexpr (Trajectories::bent) {
            auto const bent = along * (1.f - when - time()) * sagitta() * 4.f;
            return {abs(fma(-bent, length(), aside)) * cosine(slope_at(when, sagitta())), when};
        } else
            return {abs(aside), when};
    }
    /// A sample with the pixel and time of `sample` that has the velocity and sagitta of `screen_motion` at the point `offset` away. On an
    /// arc its velocity differs elsewhere.
    /// @param a_pixel the time to cross a pixel there
    QUELL_KERNEL static UsableSample at_speed(auto const& screen_motion, Real a_pixel, UsableSample const& sample,
                                              [[maybe_unused]] vec2<Real> const& offset) {
        auto const speed = speed_of(screen_motion);
        if constexpr (Trajectories::bent) {
            auto const until_there = fma(offset.x, speed.x, offset.y * speed.y) * a_pixel * a_pixel;
            auto const slope = slope_at(sample.time() + until_there, sagitta_of(screen_motion)), along = cosine(slope),
                       per_longer = along * along;
            return {{fma(-slope, speed.y, speed.x) * per_longer, fma(slope, speed.x, speed.y) * per_longer, sample.time(),
                     sample.inverse_depth(), min(a_pixel * fma(slope, slope, Real(1.f)) * along, Real(1.f / Trajectory<Real>::min_length)),
                     sagitta_of(screen_motion)}};
        } else
            return {{{speed.x, speed.y, sample.time(), sample.inverse_depth(), a_pixel}}};
    }
    QUELL_KERNEL ScreenMotion<Trajectories, Real> screen_motion() const {
        auto const v = sweep();
        if constexpr (Trajectories::bent) {
            auto const slope = slope_at(time(), sagitta());
            return {fma(slope, v.y, v.x), fma(-slope, v.x, v.y), inverse_depth(), sagitta()};
        } else
            return {v.x, v.y, inverse_depth()};
    }

private:
    QUELL_KERNEL Real sagitta() const { return component<5>(at); }
    /// Tangent of the angle between the trajectory and its sweep.
    QUELL_KERNEL static Real slope_at(Real when, Real sagitta) {
        return clamp(fma(when, Real(-8.f), Real(4.f)), Real(-4.f), Real(4.f)) * sagitta;
    }
    /// Cosine from a tangent, within 2 percent up to 45 degrees; beyond as of 45 degrees. It only makes weights.
    QUELL_KERNEL static Real cosine(Real tangent) {
        auto const squared = min(tangent * tangent, Real(1.f));
        return fma(squared, fma(squared, Real(0.16f), Real(-0.46f)), Real(1.f));
    }
};
template <class Trajectories, class Px> QUELL_KERNEL auto usable_sample(Px const& px) {
    return UsableSample<Trajectories, typename Px::Real>{px[SampleTrajectory<Trajectories>{}]};
}

template <class Trajectories> struct SampleTrajectoryOf {
    static constexpr auto name = "usable path";
    static constexpr bool leaves_signal = true;
    using parts = Parts<Trajectories>;
    using reads = Channels<Depth>;
    using emits = Channels<SampleTrajectory<Trajectories>>;
    static constexpr int farthest_tap = 0;

    template <class Px> QUELL_KERNEL auto emit_channels(Px const& px) const {
        using Real = typename Px::Real;
        auto const path = Trajectories::here(px);
        auto const moves = path.moves();
        auto const z = px[depth];
        auto const inverse_depth = 1.f / select(is_finite(z), clamp(z, Real(1e-6f), Real(1e6f)), Real(1e6f));
        auto const a_pixel = select(moves, min(sqrt(path.per_squared()), Real(1.f / Trajectory<Real>::min_length)),
                                    Real(1.f / Trajectory<Real>::min_length));
        auto const usable = select(px.missing(), Real(0.f), a_pixel);
        auto const x = masked(moves, path.sweep.x), y = masked(moves, path.sweep.y);
        if constexpr (Trajectories::bent) {
            constexpr float max_sagitta = 0.5f; // a half circle's
            auto const sagitta = fma(path.bend.x, y, -(path.bend.y * x)) * a_pixel * a_pixel;
            return emitted<Real>(SampleTrajectory<Trajectories>{}, Value<6, Real>{{x, y, path.time, inverse_depth, usable,
                                                                                   clamp(sagitta, Real(-max_sagitta), Real(max_sagitta))}});
        } else
            return emitted<Real>(SampleTrajectory<Trajectories>{}, Value<5, Real>{{x, y, path.time, inverse_depth, usable}});
    }
};
} // namespace detail

/// Emits SampleTrajectory. PathGuide<RotatingTrajectories> is RotationGuide.
/// @tparam Trajectories StraightTrajectories or BentTrajectories
template <class Trajectories> struct PathGuide {
    using parts = Parts<detail::SampleTrajectoryOf<Trajectories>>;
    using emits = Channels<SampleTrajectory<Trajectories>>;
    static constexpr bool leaves_signal = true;
    constexpr void for_each_pass(auto&& pass) const { pass(detail::SampleTrajectoryOf<Trajectories>{}); }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
