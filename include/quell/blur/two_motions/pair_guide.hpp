#pragma once

#include <quell/blur/trajectory/rotation_guide.hpp>
#include <quell/blur/two_motions/placed_motion.hpp>

/// @file
/// Contract of blur/two_motions/: motion blur where two surfaces of different velocity meet, as a foreground and a background layer.
///
///     SampleTrajectory (trajectory/)
///       |
///       v   RowExtremesOf     -> RowExtremes   fastest sample of a row, and the one least like it
///       v   LocalPairOf       -> LocalPair     the same of the window, foreground first       (every second row)
///       v   NearestPair       -> LayerMotions    a neighbour's pair where only one motion is    (every second row)
///       |
///       v   PairGather        -> ForegroundLayer, ForegroundSweep, BackgroundLayer, MeanSweep
///       v   DirectionalMean   -> ForegroundLayer, BackgroundLayer                             (where samples are far apart)
///       |
///       v   Temporal{PathSearch, PairBlend, PairFetch}: both layers are accumulated and composited
///     signal
///
/// PairGuide is the first three passes, with PathGuide before them. LineOfPixels says where PairGather looks,
/// RowTiles which pixels look along the same line. StratifiedMean averages by time strata, LayerClassifier assigns a sample to a layer.
namespace quell::inline QUELL_INSTRUCTION_SET {

/// The two motions around a pixel, foreground first: each has its velocity (pixels per open shutter), inverse depth, and relative sagitta
/// with bends. A rotating surface has the velocity that it would have at the pixel. Where there is only one motion it is the background's,
/// and the foreground's inverse depth is negative. Only rows detail::row_of_pair hold a value; a pair holds for its surroundings.
/// @tparam Trajectories StraightTrajectories, BentTrajectories or RotatingTrajectories
template <class Trajectories> struct LayerMotions : InternalChannel<Trajectories::bent ? 8 : 6> {
    static constexpr auto name = "layer_motions";
};

namespace detail {
/// Rows that share a pair, and the row of them that holds it.
inline constexpr int rows_of_pair = 2;
template <class Row> QUELL_KERNEL Row row_of_pair(Row y, auto const& size) {
    static_assert((rows_of_pair & (rows_of_pair - 1)) == 0);
    Row const row = (y & -rows_of_pair) + rows_of_pair / 2, last = size.height - 1;
    return select_index(row < last, row, last);
}
template <class Px> QUELL_KERNEL auto has_pair(Px const& px) { return px.y == row_of_pair(px.y, px.size()); }
/// What a row that holds a pair has of it. Recorded, 0 in others: on a CPU a branch has seen to them.
template <class Px, class J> QUELL_KERNEL J in_rows_of_pairs([[maybe_unused]] Px const& px, J const& pair) {
    if constexpr (records<typename Px::Real>)
        return map([&](auto a) { return masked(has_pair(px), a); }, pair);
    else
        return pair;
}

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
    M screen_motion;
    real_of<M> maximum;
    QUELL_KERNEL void offer(M const& other, real_of<M> much) {
        auto const more = much > maximum;
        screen_motion = select(more, other, screen_motion);
        maximum = select(more, much, maximum);
    }
};
template <class M> Extreme(M, real_of<M>) -> Extreme<M>; // clang 14 has no deduction for aggregates

/// Relative difference of inverse depth below which depth does not tell the foreground.
inline constexpr float min_depth_gap = 0.02f;

template <class Trajectories> struct RowExtremes : InternalChannel<2 * components_of<PlacedMotion<Trajectories, float>>> {
    static constexpr auto name = "row_extremes";
};
template <class Trajectories> struct LocalPair : InternalChannel<2 * components_of<PlacedMotion<Trajectories, float>>> {
    static constexpr auto name = "local_pair";
};

/// Fastest sample of a row, and the one whose velocity differs most from it.
template <class Trajectories> struct RowExtremesOf {
    static constexpr auto name = "motion pair, rows";
    static constexpr bool leaves_signal = true;
    using reads = Channels<SampleTrajectory<Trajectories>>;
    using emits = Channels<RowExtremes<Trajectories>>;
    int radius;

    constexpr int farthest_tap() const { return radius; }

    template <class Px> QUELL_KERNEL auto emit_channels(Px const& px) const {
        using Real = typename Px::Real;
        auto const own = placed_mover<Trajectories>(px);
        Extreme fastest{own, squared_speed(own)};
        each(px, [&](auto const& screen_motion, auto inside)
                     QUELL_INLINED { fastest.offer(screen_motion, masked(inside, squared_speed(screen_motion))); });
        Extreme other{fastest.screen_motion, Real(0.f)};
        each(px, [&](auto const& screen_motion, auto inside) QUELL_INLINED {
            other.offer(screen_motion, masked(inside, squared_difference(screen_motion, fastest.screen_motion)));
        });
        return emitted<Real>(RowExtremes<Trajectories>{}, joined(fastest.screen_motion, other.screen_motion));
    }

private:
    template <class Px, class Visit> QUELL_KERNEL void each(Px const& px, Visit&& visit) const {
        for (int i = -radius; i <= radius; ++i) {
            auto const neighbour = px.at(i, 0);
            visit(placed_mover<Trajectories>(neighbour), neighbour.inside());
        }
    }
};

/// Pair of a window, from the extremes of its rows.
template <class Trajectories> struct LocalPairOf {
    static constexpr auto name = "motion pair, columns";
    static constexpr bool leaves_signal = true;
    using reads = Channels<RowExtremes<Trajectories>>;
    using emits = Channels<LocalPair<Trajectories>>;
    int radius;
    float min_difference, relative, depth_gap, unlike, unlike_minimum;

    constexpr int farthest_tap() const { return radius; }

    template <class Px> QUELL_KERNEL auto emit_channels(Px const& px) const {
        using Real = typename Px::Real;
        if (!any(has_pair(px))) return emitted<Real>(LocalPair<Trajectories>{}, zero<Value<LocalPair<Trajectories>::components, Real>>());
        auto const own = one_of<0>(px[RowExtremes<Trajectories>{}]);
        Extreme fastest{own, squared_speed(own)};
        for (int i = -radius; i <= radius; ++i) {
            auto const screen_motion = one_of<0>(px.at(0, i)[RowExtremes<Trajectories>{}]);
            fastest.offer(screen_motion, squared_speed(screen_motion));
        }
        auto const a = fastest.screen_motion;
        Extreme other{a, Real(0.f)};
        for (int i = -radius; i <= radius; ++i) {
            auto const row = px.at(0, i)[RowExtremes<Trajectories>{}];
            other.offer(one_of<0>(row), squared_difference(one_of<0>(row), a));
            other.offer(one_of<1>(row), squared_difference(one_of<1>(row), a));
        }
        return emitted<Real>(LocalPair<Trajectories>{},
                             in_rows_of_pairs(px, ordered(a, fastest.maximum, other.screen_motion, other.maximum)));
    }

private:
    /// Foreground first. `a` is the faster one.
    template <class M, class Real> QUELL_KERNEL auto ordered(M const& a, Real squared, M const& b, Real difference) const {
        auto const near_a = inverse_depth_of(a), near_b = inverse_depth_of(b), nearer = max(near_a, near_b), farther = min(near_a, near_b);
        auto const speed = sqrt(squared);
        auto const alike = fma(max(speed - 1.f, Real(0.f)), Real(relative), Real(min_difference));
        // A slanted or rotating surface has different velocities, but within a window they differ less than this.
        auto const unlike_by = fma(speed, Real(unlike), Real(unlike_minimum));
        auto const two = both(difference > alike * alike, either(nearer > farther * (1.f + depth_gap), difference > unlike_by * unlike_by,
                                                                 squared_speed(b) <= Real(still_squared)));
        // At equal depth the faster one is the foreground.
        auto const level = nearer <= farther * (1.f + min_depth_gap);
        auto const a_in_front = both(two, either(level, near_a > near_b));
        auto const front = select(two, select(a_in_front, a, b), with_inverse_depth(a, Real(-1.f)));
        return joined(front, select(a_in_front, b, a));
    }
    template <class M, class Real> QUELL_KERNEL static M with_inverse_depth(M const& screen_motion, Real inverse_depth) {
        return make_value<components_of<M>, Real>([&](auto c) QUELL_INLINED {
            if constexpr (c == 2)
                return inverse_depth;
            else
                return component<c>(screen_motion);
        });
    }
};

/// Where a window has one motion: the pair of a neighbouring window that has a motion like it.
template <class Trajectories> struct NearestPair {
    static constexpr auto name = "motion pair, nearest";
    static constexpr bool leaves_signal = true;
    using reads = Channels<LocalPair<Trajectories>>;
    using emits = Channels<LayerMotions<Trajectories>>;
    int across, down; ///< pixels between windows; `down` is even, as only such rows hold a pair
    float likeness;

    constexpr int farthest_tap() const { return across > down ? across : down; }

    template <class Px> QUELL_KERNEL auto emit_channels(Px const& px) const {
        using Real = typename Px::Real;
        if (!any(has_pair(px)))
            return emitted<Real>(LayerMotions<Trajectories>{}, zero<Value<LayerMotions<Trajectories>::components, Real>>());
        auto const own = px[LocalPair<Trajectories>{}];
        auto pair = own;
        auto const screen_motion = one_of<1>(own);
        constexpr int beside[][2] = {{0, -1}, {0, 1}, {-1, 0}, {1, 0}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}};
        for (auto const& step : beside) {
            auto const neighbour = px.at(step[0] * across, step[1] * down);
            auto const there = neighbour[LocalPair<Trajectories>{}];
            auto const front = one_of<0>(there), back = one_of<1>(there);
            auto const unlike = min(squared_difference(screen_motion, front), squared_difference(screen_motion, back));
            auto const fits = both(neighbour.inside(), inverse_depth_of(front) > Real(0.f), inverse_depth_of(one_of<0>(pair)) < Real(0.f),
                                   unlike <= squared_difference(front, back) * (likeness * likeness));
            pair = select(fits, there, pair);
        }
        auto const here = px.position();
        return emitted<Real>(LayerMotions<Trajectories>{},
                             joined(mover_at<Trajectories>(one_of<0>(pair), here), mover_at<Trajectories>(one_of<1>(pair), here)));
    }
};
} // namespace detail

/// Finds where two surfaces of different velocity meet: the fastest sample of a small window, and the one whose velocity differs most from
/// it. They make a pair if their depths differ, the second is static, or their velocities differ too much for one surface. Samples have
/// random times, so both surfaces show in the window all over the region where one covers the other for a part of the time. Emits
/// LayerMotions in every second row, and SampleTrajectory.
/// @tparam Trajectories StraightTrajectories, BentTrajectories or RotatingTrajectories
template <class Trajectories = StraightTrajectories> struct PairGuide {
    using parts = Parts<PathGuide<Trajectories>>;
    using emits = Channels<detail::RowExtremes<Trajectories>, detail::LocalPair<Trajectories>, LayerMotions<Trajectories>>;
    static constexpr bool leaves_signal = true;
    /// Half width and half height of the window, in pixels.
    int across = 4, down = 1;
    float min_difference = 0.1f; ///< pixels; velocities that differ by less are equal
    float relative = 0.25f;      ///< added to `min_difference` per pixel of the faster speed beyond the first
    /// Relative, but `unlike_minimum` in pixels: surfaces that differ by less in depth are one, unless one is static or their velocities
    /// differ by more than `unlike` times the faster speed plus `unlike_minimum`.
    float depth_gap = 0.05f, unlike = 0.5f, unlike_minimum = 2.f;
    float likeness = 0.5f; ///< match radius to either motion of a neighbour's pair, relative to the difference between these
    QUELL_NO_UNIQUE_ADDRESS PathGuide<Trajectories> paths{}; ///< makes SampleTrajectory

    constexpr void for_each_pass(auto&& pass) const {
        paths.for_each_pass(pass);
        pass(detail::RowExtremesOf<Trajectories>{across});
        pass(detail::LocalPairOf<Trajectories>{down, min_difference, relative, depth_gap, unlike, unlike_minimum});
        pass(detail::NearestPair<Trajectories>{2 * across, detail::rows_of_pair * down, likeness});
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
