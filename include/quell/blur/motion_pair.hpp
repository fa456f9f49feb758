#pragma once

#include <quell/blur/path.hpp>
#include <quell/filter/filter_kernel.hpp>

namespace quell {

/// The two motions that meet around a pixel: of what is in front, then of what is behind, each with its speed (pixels in the time that the
/// shutter is open), its depth, and its bend where paths are bent. Where only one thing is around it is the one behind, and the depth of
/// the front is negative.
/// @tparam Paths StraightPaths or BentPaths
template <class Paths> struct MotionPair : Channel<Paths::bent ? 10 : 6> { static constexpr auto name = "motion_pair"; };

namespace detail {
/// What a sample shows, as far as motion goes: its speed at the sample's time, its depth, and its bend.
template <class Paths, class Real> using Mover = Value<Paths::bent ? 5 : 3, Real>;

template <class Real> QUELL_KERNEL Real usable_depth(Real z) { return select(is_finite(z), clamp(z, Real(1e-6f), Real(1e6f)), Real(1e6f)); }
template <class Paths, class PathType, class Real> QUELL_KERNEL auto mover_of(PathType const& path, Real z) {
    auto const moves = path.moves();
    auto const speed = path.speed_when_seen();
    auto const x = select(moves, speed.x, Real(0.f)), y = select(moves, speed.y, Real(0.f));
    if constexpr (Paths::bent)
        return Mover<Paths, Real>{{x, y, usable_depth(z), select(moves, path.bend.x, Real(0.f)), select(moves, path.bend.y, Real(0.f))}};
    else
        return Mover<Paths, Real>{x, y, usable_depth(z)};
}
template <class Paths, class Px> QUELL_KERNEL auto mover_here(Px const& px) { return mover_of<Paths>(Paths::here(px), px[depth]); }
template <class M> QUELL_KERNEL auto speed_of(M const& mover) { return vec2<real_of<M>>{component<0>(mover), component<1>(mover)}; }
template <class M> QUELL_KERNEL auto depth_of(M const& mover) { return component<2>(mover); }
template <class M> QUELL_KERNEL auto squared_speed(M const& mover) {
    return fma(component<0>(mover), component<0>(mover), component<1>(mover) * component<1>(mover));
}
/// How different two motions are: the squared distance of their speeds.
template <class M> QUELL_KERNEL auto squared_difference(M const& a, M const& b) {
    auto const x = component<0>(a) - component<0>(b), y = component<1>(a) - component<1>(b);
    return fma(x, x, y * y);
}

/// Two movers in one value, and back.
template <class M> QUELL_KERNEL auto joined(M const& first, M const& second) {
    constexpr int n = components_of<M>;
    return make_value<2 * n, real_of<M>>([&](auto c) __attribute__((always_inline)) {
        if constexpr (c < n)
            return component<c>(first);
        else
            return component<c - n>(second);
    });
}
template <int which, class J> QUELL_KERNEL auto one_of(J const& both) {
    constexpr int n = components_of<J> / 2;
    return make_value<n, real_of<J>>([&](auto c) __attribute__((always_inline)) { return component<which * n + c>(both); });
}

template <class Paths> struct RowExtremes : Channel<MotionPair<Paths>::components> { static constexpr auto name = "row_extremes"; };
template <class Paths> struct LocalPair : Channel<MotionPair<Paths>::components> { static constexpr auto name = "local_pair"; };

/// The fastest sample of a row, and the one that moves least like it.
template <class Paths> struct RowExtremesOf {
    static constexpr auto name = "motion pair, rows";
    static constexpr bool leaves_signal = true;
    using reads = decltype(Channels<Depth>{} | reads_of<Paths>{});
    using emits = Channels<RowExtremes<Paths>>;
    int radius;

    template <class Px> QUELL_KERNEL auto emit(Px const& px) const {
        using Real = typename Px::Real;
        auto fastest = mover_here<Paths>(px);
        auto squared = squared_speed(fastest);
        for (int i = -radius; i <= radius; ++i) {
            auto const near = px.at(i, 0);
            auto const mover = mover_here<Paths>(near);
            auto const faster = both(near.inside(), squared_speed(mover) > squared);
            fastest = select(faster, mover, fastest);
            squared = select(faster, squared_speed(mover), squared);
        }
        auto other = fastest;
        Real difference(0.f);
        for (int i = -radius; i <= radius; ++i) {
            auto const near = px.at(i, 0);
            auto const mover = mover_here<Paths>(near);
            auto const more = both(near.inside(), squared_difference(mover, fastest) > difference);
            other = select(more, mover, other);
            difference = select(more, squared_difference(mover, fastest), difference);
        }
        return emitted<Real>(RowExtremes<Paths>{}, joined(fastest, other));
    }
};

/// The pair of a window from the extremes of its rows.
template <class Paths> struct LocalPairOf {
    static constexpr auto name = "motion pair, columns";
    static constexpr bool leaves_signal = true;
    using reads = Channels<RowExtremes<Paths>>;
    using emits = Channels<LocalPair<Paths>>;
    int radius;
    float least, relative, depth_gap;

    template <class Px> QUELL_KERNEL auto emit(Px const& px) const {
        using Real = typename Px::Real;
        auto a = one_of<0>(px[RowExtremes<Paths>{}]);
        auto squared = squared_speed(a);
        for (int i = -radius; i <= radius; ++i) {
            auto const mover = one_of<0>(px.at(0, i)[RowExtremes<Paths>{}]);
            auto const faster = squared_speed(mover) > squared;
            a = select(faster, mover, a);
            squared = select(faster, squared_speed(mover), squared);
        }
        auto b = a;
        Real difference(0.f);
        auto const take = [&](auto const& mover) __attribute__((always_inline)) {
            auto const more = squared_difference(mover, a) > difference;
            b = select(more, mover, b);
            difference = select(more, squared_difference(mover, a), difference);
        };
        for (int i = -radius; i <= radius; ++i) {
            auto const row = px.at(0, i)[RowExtremes<Paths>{}];
            take(one_of<0>(row)), take(one_of<1>(row));
        }
        auto const za = depth_of(a), zb = depth_of(b);
        auto const apart = max(za, zb) > min(za, zb) * (1.f + depth_gap);
        // What moves over something of its own depth that stands still is in front.
        auto const two = both(difference > max(Real(least * least), squared * (relative * relative)),
                              either(apart, squared_speed(b) <= Real(Path<float>::least * Path<float>::least)));
        auto const a_in_front = both(two, either(invert(apart), za < zb));
        auto const front = select(two, select(a_in_front, a, b), at_depth(a, Real(-1.f)));
        return emitted<Real>(LocalPair<Paths>{}, joined(front, select(a_in_front, b, a)));
    }

private:
    template <class M, class Real> QUELL_KERNEL static M at_depth(M const& mover, Real z) {
        return make_value<components_of<M>, Real>([&](auto c) __attribute__((always_inline)) {
            if constexpr (c == 2)
                return z;
            else
                return component<c>(mover);
        });
    }
};

/// Where there is only one motion, the pair of a window beside that it may be one of.
template <class Paths> struct NearestPair {
    static constexpr auto name = "motion pair, nearest";
    static constexpr bool leaves_signal = true;
    using reads = Channels<LocalPair<Paths>>;
    using emits = Channels<MotionPair<Paths>>;
    int across, down; ///< pixels from window to window
    float likeness;

    template <class Px> QUELL_KERNEL auto emit(Px const& px) const {
        using Real = typename Px::Real;
        auto const own = px[LocalPair<Paths>{}];
        auto pair = own;
        auto const mover = one_of<1>(own);
        constexpr int beside[][2] = {{0, -1}, {0, 1}, {-1, 0}, {1, 0}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}};
        for (auto const& step : beside) {
            auto const near = px.at(step[0] * across, step[1] * down);
            auto const there = near[LocalPair<Paths>{}];
            auto const front = one_of<0>(there), back = one_of<1>(there);
            auto const unlike = min(squared_difference(mover, front), squared_difference(mover, back));
            auto const fits = both(near.inside(), depth_of(front) > Real(0.f), depth_of(one_of<0>(pair)) < Real(0.f),
                                   unlike <= squared_difference(front, back) * (likeness * likeness));
            pair = select(fits, there, pair);
        }
        return emitted<Real>(MotionPair<Paths>{}, pair);
    }
};
} // namespace detail

/// Finds where two things meet that move differently, and how each of them moves: the fastest sample in a small window and the one that
/// moves least like it, if they are at different depths too. Since every sample has its own time, the window holds samples of both all over
/// the region in which one covers the other for a part of the time.
/// Emits MotionPair. Windows are made for every pixel; what reads them does best to share one among neighbours (PairGather).
/// @tparam Paths StraightPaths or BentPaths
template <class Paths = StraightPaths> struct MotionPairs {
    using reads = decltype(Channels<Depth>{} | reads_of<Paths>{});
    using emits = Channels<detail::RowExtremes<Paths>, detail::LocalPair<Paths>, MotionPair<Paths>>;
    static constexpr bool leaves_signal = true;
    int across = 4, down = 1; ///< how far the window reaches, in pixels
    float least = 1.f;        ///< pixels; motions that differ less are one
    float relative = 0.25f;   ///< of the faster's speed; likewise
    float depth_gap = 0.05f;  ///< relative; what is nearer to each other in depth is one
    float likeness = 0.5f;    ///< of the difference between two motions beside: what is nearer to one of them than that may be it

    constexpr void for_each_pass(auto&& pass) const {
        pass(detail::RowExtremesOf<Paths>{across});
        pass(detail::LocalPairOf<Paths>{down, least, relative, depth_gap});
        pass(detail::NearestPair<Paths>{2 * across, 2 * down, likeness});
    }
};

} // namespace quell
