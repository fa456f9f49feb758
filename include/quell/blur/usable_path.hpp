#pragma once

#include <quell/blur/path.hpp>

namespace quell {

/// How what each pixel's sample shows moves, made usable once for all that look at it: its sweep (pixels; 0 where it stands still), its
/// time, 1 / depth, and the time that it takes to pass a pixel as a part of the open shutter (0 for a sample that is missing); then its
/// bend where paths are bent. Made of what StraightPaths or BentPaths read.
template <class Paths> struct UsablePath : Channel<Paths::bent ? 7 : 5> { static constexpr auto name = "usable_path"; };

namespace detail {

/// What a sample shows, as far as motion and depth tell it from other things: its speed (pixels in the time that the shutter is open), its
/// nearness (1 / depth), and its bend.
template <class Paths, class Real> using Mover = Value<Paths::bent ? 5 : 3, Real>;
/// What moves less than this, squared, in pixels, stands still.
inline constexpr float still_squared = Path<float>::least * Path<float>::least;

template <class M> QUELL_KERNEL auto speed_of(M const& mover) { return vec2<real_of<M>>{component<0>(mover), component<1>(mover)}; }
template <class M> QUELL_KERNEL auto nearness_of(M const& mover) { return component<2>(mover); }
template <class M> QUELL_KERNEL auto bend_of([[maybe_unused]] M const& mover) {
    if constexpr (3 < components_of<M>)
        return vec2<real_of<M>>{component<3>(mover), component<4>(mover)};
    else
        return zero<vec2<real_of<M>>>();
}
template <class M> QUELL_KERNEL auto squared_speed(M const& mover) {
    return fma(component<0>(mover), component<0>(mover), component<1>(mover) * component<1>(mover));
}
/// How different two motions are: the squared distance of their speeds.
template <class M> QUELL_KERNEL auto squared_difference(M const& a, M const& b) {
    auto const x = component<0>(a) - component<0>(b), y = component<1>(a) - component<1>(b);
    return fma(x, x, y * y);
}

/// A usable path as kernels want it.
template <class Paths, class Real> struct UsableSample {
    Value<UsablePath<Paths>::components, Real> at;

    QUELL_KERNEL vec2<Real> sweep() const { return {component<0>(at), component<1>(at)}; }
    QUELL_KERNEL Real time() const { return component<2>(at); }
    QUELL_KERNEL Real nearness() const { return component<3>(at); }
    QUELL_KERNEL Real time_per_pixel() const { return component<4>(at); }
    /// Of its sweep, in pixels; 0 where it stands still.
    QUELL_KERNEL Real length() const { return fma(sweep().x, sweep().x, sweep().y * sweep().y) * time_per_pixel(); }
    QUELL_KERNEL auto moves() const { return time_per_pixel() < Real(1.f / Path<Real>::least); }
    QUELL_KERNEL auto known() const { return time_per_pixel() > Real(0.f); }
    QUELL_KERNEL auto path() const {
        Path<Real> const straight{sweep(), time(), fma(sweep().x, sweep().x, sweep().y * sweep().y)};
        if constexpr (Paths::bent)
            return BentPath<Real>{straight, {component<5>(at), component<6>(at)}};
        else
            return straight;
    }
    /// How far from a point it passes, and when; `offset` is the point minus the sample's pixel.
    QUELL_KERNEL typename Path<Real>::Passing passing(vec2<Real> const& offset) const {
        auto const moving = passing_in_motion(offset);
        if constexpr (Paths::bent) return moving;
        return {select(moves(), moving.distance, sqrt(fma(offset.x, offset.x, offset.y * offset.y))), moving.when};
    }
    /// The same for what is known to move.
    QUELL_KERNEL typename Path<Real>::Passing passing_in_motion(vec2<Real> const& offset) const {
        if constexpr (Paths::bent) return path().passing(offset);
        auto const v = sweep();
        auto const along = fma(offset.x, v.x, offset.y * v.y) * time_per_pixel() * time_per_pixel();
        auto const aside = abs(fma(offset.x, v.y, -(offset.y * v.x))) * time_per_pixel();
        return {aside, time() + along};
    }
    /// Something else at a sample's place and time, such that it has a given speed, bend, and time to pass a pixel once it is where a
    /// point lies, `offset` from the sample's pixel: what bends has not been going that way all the time.
    QUELL_KERNEL static UsableSample at_speed(vec2<Real> const& speed, [[maybe_unused]] vec2<Real> const& bend, Real a_pixel,
                                              UsableSample const& sample, [[maybe_unused]] vec2<Real> const& offset) {
        if constexpr (Paths::bent) {
            auto const until_there = fma(offset.x, speed.x, offset.y * speed.y) * a_pixel * a_pixel;
            auto const turned = fma(sample.time() + until_there, Real(8.f), Real(-4.f));
            auto const x = fma(bend.x, turned, speed.x), y = fma(bend.y, turned, speed.y);
            return {{{x, y, sample.time(), sample.nearness(), per_length(x, y), bend.x, bend.y}}};
        } else
            return {{{speed.x, speed.y, sample.time(), sample.nearness(), a_pixel}}};
    }
    QUELL_KERNEL Mover<Paths, Real> mover() const {
        auto const speed = path().speed_when_seen();
        if constexpr (Paths::bent)
            return {{speed.x, speed.y, nearness(), component<5>(at), component<6>(at)}};
        else
            return {speed.x, speed.y, nearness()};
    }

private:
    QUELL_KERNEL static Real per_length(Real x, Real y) { return 1.f / max(sqrt(fma(x, x, y * y)), Real(Path<Real>::least)); }
};
template <class Paths, class Px> QUELL_KERNEL auto usable_sample(Px const& px) {
    return UsableSample<Paths, typename Px::Real>{px[UsablePath<Paths>{}]};
}

template <class Paths> struct UsablePathOf {
    static constexpr auto name = "usable path";
    static constexpr bool leaves_signal = true;
    using reads = decltype(Channels<Depth>{} | reads_of<Paths>{});
    using emits = Channels<UsablePath<Paths>>;

    template <class Px> QUELL_KERNEL auto emit(Px const& px) const {
        using Real = typename Px::Real;
        auto const path = Paths::here(px);
        auto const moves = path.moves();
        auto const z = px[depth];
        auto const nearness = 1.f / select(is_finite(z), clamp(z, Real(1e-6f), Real(1e6f)), Real(1e6f));
        auto const a_pixel = select(moves, min(sqrt(path.per_squared()), Real(1.f / Path<Real>::least)), Real(1.f / Path<Real>::least));
        auto const usable = select(px.missing(), Real(0.f), a_pixel);
        auto const x = masked(moves, path.sweep.x), y = masked(moves, path.sweep.y);
        if constexpr (Paths::bent) {
            auto const bend_x = masked(moves, path.bend.x), bend_y = masked(moves, path.bend.y);
            return emitted<Real>(UsablePath<Paths>{}, Value<7, Real>{{x, y, path.time, nearness, usable, bend_x, bend_y}});
        } else
            return emitted<Real>(UsablePath<Paths>{}, Value<5, Real>{{x, y, path.time, nearness, usable}});
    }
};
} // namespace detail

} // namespace quell
