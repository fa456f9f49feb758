#pragma once

#include <quell/blur/trajectory/turn_guide.hpp>
#include <quell/blur/two_motions/placed_mover.hpp>

namespace quell {

/// The two motions that meet around a pixel: of what is in front, then of what is behind, each with its speed (pixels in the time that the
/// shutter is open), its nearness (1 / depth), and its sagitta where paths are bent; what turns has the speed that it would have at the
/// pixel. Where only one thing is around it is the one behind, and the nearness of the front is negative. Of two rows only the one of
/// detail::row_of_pair has it: a pair holds for its surroundings.
/// @tparam Paths StraightPaths, BentPaths or TurningPaths
template <class Paths> struct MotionPair : MadeChannel<Paths::bent ? 8 : 6> { static constexpr auto name = "motion_pair"; };

namespace detail {
/// Rows that share one pair, and which of them has it.
inline constexpr int rows_of_pair = 2;
QUELL_KERNEL int row_of_pair(int y, Extent size) {
    int const row = y / rows_of_pair * rows_of_pair + rows_of_pair / 2, last = size.height - 1;
    return row < last ? row : last;
}
template <class Px> QUELL_KERNEL bool has_pair(Px const& px) { return px.y == row_of_pair(px.y, px.size()); }

/// Two movers in one value, and back.
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

/// The mover, of all that it is offered, with the most of something.
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

/// Relative; of things nearer in depth than that, depth doesn't say which is in front.
inline constexpr float least_depth_gap = 0.02f;

template <class Paths> struct RowExtremes : MadeChannel<2 * components_of<PlacedMover<Paths, float>>> {
    static constexpr auto name = "row_extremes";
};
template <class Paths> struct LocalPair : MadeChannel<2 * components_of<PlacedMover<Paths, float>>> {
    static constexpr auto name = "local_pair";
};

/// The fastest sample of a row, and the one that moves least like it.
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

/// The pair of a window from the extremes of its rows.
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
    /// The faster and the other, whichever is in front first.
    template <class M, class Real> QUELL_KERNEL auto ordered(M const& a, Real squared, M const& b, Real difference) const {
        auto const near_a = nearness_of(a), near_b = nearness_of(b), nearer = max(near_a, near_b), farther = min(near_a, near_b);
        auto const speed = sqrt(squared);
        auto const alike = fma(max(speed - 1.f, Real(0.f)), Real(relative), Real(least));
        // A surface that slants or turns has motions of its own that differ, but not so much within a window.
        auto const unlike_by = fma(speed, Real(unlike), Real(unlike_least));
        auto const two = both(difference > alike * alike, either(nearer > farther * (1.f + depth_gap), difference > unlike_by * unlike_by,
                                                                 squared_speed(b) <= Real(still_squared)));
        // What moves faster over something of its own depth is in front.
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

/// Where there is only one motion, the pair of a window beside that it may be one of.
template <class Paths> struct NearestPair {
    static constexpr auto name = "motion pair, nearest";
    static constexpr bool leaves_signal = true;
    using reads = Channels<LocalPair<Paths>>;
    using emits = Channels<MotionPair<Paths>>;
    int across, down; ///< pixels from window to window; `down` leads from rows that have a pair to such rows
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

/// Finds where two things meet that move differently, and how each of them moves: the fastest sample in a small window and the one that
/// moves least like it, if they are at different depths, the latter stands still, or their motions are too unlike to be of one surface.
/// Since every sample has its own time, the window holds samples of both all over the region in which one covers the other for a part of
/// the time. Emits MotionPair, for every second row, and UsablePath for who looks at single samples afterwards.
/// @tparam Paths StraightPaths, BentPaths, or TurningPaths, which a TurnGuide measures
template <class Paths = StraightPaths> struct PairGuide {
    using parts = Parts<PathGuide<Paths>>;
    using emits = Channels<detail::RowExtremes<Paths>, detail::LocalPair<Paths>, MotionPair<Paths>>;
    static constexpr bool leaves_signal = true;
    int across = 4, down = 1; ///< how far the window reaches, in pixels
    float least = 0.1f;       ///< pixels; motions that differ less are one
    float relative = 0.25f;   ///< how much more they may differ, of the faster's speed beyond one pixel
    /// Relative; what is nearer to each other in depth is one, unless one of them stands still or their motions differ by more than both
    /// `unlike`, of the faster's speed, and `unlike_least`, in pixels.
    float depth_gap = 0.05f, unlike = 0.5f, unlike_least = 2.f;
    float likeness = 0.5f; ///< of the difference between two motions beside: what is nearer to one of them than that may be it
    [[no_unique_address]] PathGuide<Paths> paths{};

    constexpr void for_each_pass(auto&& pass) const {
        paths.for_each_pass(pass);
        pass(detail::RowExtremesOf<Paths>{across});
        pass(detail::LocalPairOf<Paths>{down, least, relative, depth_gap, unlike, unlike_least});
        pass(detail::NearestPair<Paths>{2 * across, detail::rows_of_pair * down, likeness});
    }
};

} // namespace quell
