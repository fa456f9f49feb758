#pragma once

#include <quell/blur/trajectory/turn_guide.hpp>
#include <quell/blur/two_motions/placed_mover.hpp>

/// @file
/// Contract of blur/two_motions/: motion blur where two surfaces of different velocity meet, as a foreground and a background layer.
///
///     UsablePath (trajectory/)
///       |
///       v   RowExtremesOf     -> RowExtremes   fastest sample of a row, and the one least like it
///       v   LocalPairOf       -> LocalPair     the same of the window, foreground first       (every second row)
///       v   NearestPair       -> MotionPair    a neighbour's pair where only one motion is    (every second row)
///       |
///       v   PairGather        -> FrontLayer, FrontSweep, BackLayer, MeanSweep
///       |
///       v   Temporal{PathSearch, PairBlend, PairFetch}: both layers are accumulated and composited
///     signal
///
/// PairGuide is the first three passes, with PathGuide before them. LineOfPixels and AdaptiveFootprint say where PairGather looks,
/// PartMeans averages by time strata, WhichOfTwo assigns a sample to a layer.
namespace quell {

/// The two motions around a pixel, foreground first: each has its velocity (pixels per open shutter), inverse depth, and relative sagitta
/// with bends. A rotating surface has the velocity that it would have at the pixel. Where there is only one motion it is the background's,
/// and the foreground's inverse depth is negative. Only rows detail::row_of_pair hold a value; a pair holds for its surroundings.
/// @tparam Paths StraightPaths, BentPaths or TurningPaths
template <class Paths> struct MotionPair : MadeChannel<Paths::bent ? 8 : 6> { static constexpr auto name = "motion_pair"; };

namespace detail {
/// Rows that share a pair, and the row of them that holds it.
inline constexpr int rows_of_pair = 2;
QUELL_KERNEL int row_of_pair(int y, Extent size) {
    int const row = y / rows_of_pair * rows_of_pair + rows_of_pair / 2, last = size.height - 1;
    return row < last ? row : last;
}
template <class Px> QUELL_KERNEL bool has_pair(Px const& px) { return px.y == row_of_pair(px.y, px.size()); }

/// Joins two motions into one value; one_of takes them apart.
template <class M> QUELL_KERNEL auto joined(M const& first, M const& second) {
    constexpr int n = components_of<M>;
    return make_value<2 * n, real_of<M>>([&](auto c) QUELL_INLINED {
        if constexpr (c < n)
            return component<c>(first);
        else
            return component<c - n>(second);
    });
}
template <int which, class J> QUELL_KERNEL auto one_of(J const& both) {
    constexpr int n = components_of<J> / 2;
    return make_value<n, real_of<J>>([&](auto c) QUELL_INLINED { return component<which * n + c>(both); });
}

/// Keeps the motion that is largest by some measure.
template <class M> struct Extreme {
    M mover;
    real_of<M> most;
    QUELL_KERNEL void offer(M const& other, real_of<M> much) {
        auto const more = much > most;
        mover = select(more, other, mover);
        most = select(more, much, most);
    }
};
template <class M> Extreme(M, real_of<M>) -> Extreme<M>; // clang 14 has no deduction for aggregates

/// Relative difference of inverse depth below which depth does not tell the foreground.
inline constexpr float least_depth_gap = 0.02f;

template <class Paths> struct RowExtremes : MadeChannel<2 * components_of<PlacedMover<Paths, float>>> {
    static constexpr auto name = "row_extremes";
};
template <class Paths> struct LocalPair : MadeChannel<2 * components_of<PlacedMover<Paths, float>>> {
    static constexpr auto name = "local_pair";
};

/// Fastest sample of a row, and the one whose velocity differs most from it.
template <class Paths> struct RowExtremesOf {
    static constexpr auto name = "motion pair, rows";
    static constexpr bool leaves_signal = true;
    using reads = Channels<UsablePath<Paths>>;
    using emits = Channels<RowExtremes<Paths>>;
    int radius;

    template <class Px> QUELL_KERNEL auto emit_channels(Px const& px) const {
        using Real = typename Px::Real;
        auto const own = placed_mover<Paths>(px);
        Extreme fastest{own, squared_speed(own)};
        each(px, [&](auto const& mover, auto inside) QUELL_INLINED { fastest.offer(mover, masked(inside, squared_speed(mover))); });
        Extreme other{fastest.mover, Real(0.f)};
        each(px, [&](auto const& mover, auto inside)
                     QUELL_INLINED { other.offer(mover, masked(inside, squared_difference(mover, fastest.mover))); });
        return emitted<Real>(RowExtremes<Paths>{}, joined(fastest.mover, other.mover));
    }

private:
    template <class Px, class Visit> QUELL_KERNEL void each(Px const& px, Visit&& visit) const {
        for (int i = -radius; i <= radius; ++i) {
            auto const neighbour = px.at(i, 0);
            visit(placed_mover<Paths>(neighbour), neighbour.inside());
        }
    }
};

/// Pair of a window, from the extremes of its rows.
template <class Paths> struct LocalPairOf {
    static constexpr auto name = "motion pair, columns";
    static constexpr bool leaves_signal = true;
    using reads = Channels<RowExtremes<Paths>>;
    using emits = Channels<LocalPair<Paths>>;
    int radius;
    float least, relative, depth_gap, unlike, unlike_least;

    template <class Px> QUELL_KERNEL auto emit_channels(Px const& px) const {
        using Real = typename Px::Real;
        if (!has_pair(px)) return emitted<Real>(LocalPair<Paths>{}, zero<Value<LocalPair<Paths>::components, Real>>());
        auto const own = one_of<0>(px[RowExtremes<Paths>{}]);
        Extreme fastest{own, squared_speed(own)};
        for (int i = -radius; i <= radius; ++i) {
            auto const mover = one_of<0>(px.at(0, i)[RowExtremes<Paths>{}]);
            fastest.offer(mover, squared_speed(mover));
        }
        auto const a = fastest.mover;
        Extreme other{a, Real(0.f)};
        for (int i = -radius; i <= radius; ++i) {
            auto const row = px.at(0, i)[RowExtremes<Paths>{}];
            other.offer(one_of<0>(row), squared_difference(one_of<0>(row), a));
            other.offer(one_of<1>(row), squared_difference(one_of<1>(row), a));
        }
        return emitted<Real>(LocalPair<Paths>{}, ordered(a, fastest.most, other.mover, other.most));
    }

private:
    /// Foreground first. `a` is the faster one.
    template <class M, class Real> QUELL_KERNEL auto ordered(M const& a, Real squared, M const& b, Real difference) const {
        auto const near_a = nearness_of(a), near_b = nearness_of(b), nearer = max(near_a, near_b), farther = min(near_a, near_b);
        auto const speed = sqrt(squared);
        auto const alike = fma(max(speed - 1.f, Real(0.f)), Real(relative), Real(least));
        // A slanted or rotating surface has different velocities, but within a window they differ less than this.
        auto const unlike_by = fma(speed, Real(unlike), Real(unlike_least));
        auto const two = both(difference > alike * alike, either(nearer > farther * (1.f + depth_gap), difference > unlike_by * unlike_by,
                                                                 squared_speed(b) <= Real(still_squared)));
        // At equal depth the faster one is the foreground.
        auto const level = nearer <= farther * (1.f + least_depth_gap);
        auto const a_in_front = both(two, either(level, near_a > near_b));
        auto const front = select(two, select(a_in_front, a, b), at_nearness(a, Real(-1.f)));
        return joined(front, select(a_in_front, b, a));
    }
    template <class M, class Real> QUELL_KERNEL static M at_nearness(M const& mover, Real nearness) {
        return make_value<components_of<M>, Real>([&](auto c) QUELL_INLINED {
            if constexpr (c == 2)
                return nearness;
            else
                return component<c>(mover);
        });
    }
};

/// Where a window has one motion: the pair of a neighbouring window that has a motion like it.
template <class Paths> struct NearestPair {
    static constexpr auto name = "motion pair, nearest";
    static constexpr bool leaves_signal = true;
    using reads = Channels<LocalPair<Paths>>;
    using emits = Channels<MotionPair<Paths>>;
    int across, down; ///< pixels between windows; `down` is even, as only such rows hold a pair
    float likeness;

    template <class Px> QUELL_KERNEL auto emit_channels(Px const& px) const {
        using Real = typename Px::Real;
        if (!has_pair(px)) return emitted<Real>(MotionPair<Paths>{}, zero<Value<MotionPair<Paths>::components, Real>>());
        auto const own = px[LocalPair<Paths>{}];
        auto pair = own;
        auto const mover = one_of<1>(own);
        constexpr int beside[][2] = {{0, -1}, {0, 1}, {-1, 0}, {1, 0}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}};
        for (auto const& step : beside) {
            auto const neighbour = px.at(step[0] * across, step[1] * down);
            auto const there = neighbour[LocalPair<Paths>{}];
            auto const front = one_of<0>(there), back = one_of<1>(there);
            auto const unlike = min(squared_difference(mover, front), squared_difference(mover, back));
            auto const fits = both(neighbour.inside(), nearness_of(front) > Real(0.f), nearness_of(one_of<0>(pair)) < Real(0.f),
                                   unlike <= squared_difference(front, back) * (likeness * likeness));
            pair = select(fits, there, pair);
        }
        auto const here = px.position();
        return emitted<Real>(MotionPair<Paths>{}, joined(mover_at<Paths>(one_of<0>(pair), here), mover_at<Paths>(one_of<1>(pair), here)));
    }
};
} // namespace detail

/// Finds where two surfaces of different velocity meet: the fastest sample of a small window, and the one whose velocity differs most from
/// it. They make a pair if their depths differ, the second is static, or their velocities differ too much for one surface. Samples have
/// random times, so both surfaces show in the window all over the region where one covers the other for a part of the time. Emits
/// MotionPair in every second row, and UsablePath.
/// @tparam Paths StraightPaths, BentPaths or TurningPaths
template <class Paths = StraightPaths> struct PairGuide {
    using parts = Parts<PathGuide<Paths>>;
    using emits = Channels<detail::RowExtremes<Paths>, detail::LocalPair<Paths>, MotionPair<Paths>>;
    static constexpr bool leaves_signal = true;
    /// Half width and half height of the window, in pixels.
    int across = 4, down = 1;
    float least = 0.1f;     ///< pixels; velocities that differ by less are equal
    float relative = 0.25f; ///< added to `least` per pixel of the faster speed beyond the first
    /// Relative, but `unlike_least` in pixels: surfaces that differ by less in depth are one, unless one is static or their velocities
    /// differ by more than `unlike` times the faster speed plus `unlike_least`.
    float depth_gap = 0.05f, unlike = 0.5f, unlike_least = 2.f;
    float likeness = 0.5f; ///< match radius to either motion of a neighbour's pair, relative to the difference between these
    [[no_unique_address]] PathGuide<Paths> paths{}; ///< makes UsablePath

    constexpr void for_each_pass(auto&& pass) const {
        paths.for_each_pass(pass);
        pass(detail::RowExtremesOf<Paths>{across});
        pass(detail::LocalPairOf<Paths>{down, least, relative, depth_gap, unlike, unlike_least});
        pass(detail::NearestPair<Paths>{2 * across, detail::rows_of_pair * down, likeness});
    }
};

} // namespace quell
