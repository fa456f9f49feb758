#pragma once

#include <quell/blur/layers.hpp>
#include <quell/blur/motion_pair.hpp>
#include <quell/blur/pixel_under.hpp>

namespace quell {

/// What is behind: the signal, and how many samples it is the mean of; what stands still and is seen counts as many, what was guessed from
/// neighbours as a small part of one.
template <ChannelTag Signal> struct BackLayer : Channel<Signal::components + 1> {
    static constexpr auto name = "back_layer";
    static constexpr float certain = 64.f, guessed = 0.05f;
};

namespace detail {
/// Sums of samples by when they pass: the mean of the means of equal parts of the open shutter has much less noise than the mean of all,
/// since times are random and crowd.
/// @tparam V what is summed; its last component is the weight that the mean divides by
template <class V> struct PartSums {
    using Real = real_of<V>;
    static constexpr int most = 8;              ///< parts: they are as long as it takes to pass `pixels_a_part`, at least
    static constexpr float pixels_a_part = 2.f;
    Real count; ///< of parts, from 1
    V part[most];

    QUELL_KERNEL explicit PartSums(Real pixels)
        : count(floor(clamp(pixels * (1.f / pixels_a_part), Real(1.f), Real(static_cast<float>(most))))) {
        for (auto& p : part) p = zero<V>();
    }
    QUELL_KERNEL void add(V const& value, Real when) {
        // The end of the last part belongs to it.
        auto const which = min(floor(when * count), count - 1.f);
        for (int i = 0; i < most; ++i) {
            auto const here = abs(which - static_cast<float>(i)) < Real(0.5f);
            part[i] = map(
                [&](auto sum, auto a) __attribute__((always_inline)) { return sum + select(here, a, Real(0.f)); }, part[i], value);
        }
    }
    /// The mean without the weight, and how many parts something is known of.
    QUELL_KERNEL auto mean() const {
        auto sum = zero<V>();
        for (auto const& p : part) {
            auto const weight = weight_of(p);
            auto const some = weight > Real(0.f);
            sum = add_scaled(sum, p, select(some, 1.f / max(weight, Real(1e-12f)), Real(0.f)));
        }
        auto const known = weight_of(sum);
        return scale(signal_of(sum), 1.f / max(known, Real(1.f)));
    }
};

/// The pixels along a line through a pixel to either side, as far as something moves while the shutter is open: all of them, or as many as
/// there is time for. A line that is not parallel to an axis passes between two pixels everywhere, and visits both.
template <class Real> struct LineOfPixels {
    vec2<Real> speed, bend;
    decltype(Real(0.f) < Real(0.f)) steep, slanted;
    Real slope, reach, steps, step, bent;

    QUELL_KERNEL LineOfPixels(vec2<Real> const& speed_, vec2<Real> const& bend_, int budget) : speed(speed_), bend(bend_) {
        steep = abs(speed.y) > abs(speed.x);
        auto const major = select(steep, speed.y, speed.x), minor = select(steep, speed.x, speed.y);
        slope = minor / select(abs(major) > Real(1e-6f), major, Real(1.f));
        bent = fma(-slope, select(steep, bend.y, bend.x), select(steep, bend.x, bend.y));
        slanted = either(abs(slope) > Real(0.02f), abs(bent) > Real(0.1f));
        reach = floor(abs(major)) + 1.f;
        steps = min(select(slanted, Real(static_cast<float>(budget / 2)), Real(static_cast<float>(budget))), fma(reach, Real(2.f), Real(1.f)));
        step = 2.f * reach / max(steps - 1.f, Real(1.f));
    }
    /// Calls visit(offset, mask) for each.
    template <class Mask, class Visit> QUELL_KERNEL void for_each(Mask wanted, Visit&& visit) const {
        for (int i = 0;; ++i) {
            auto const number = Real(static_cast<float>(i));
            auto const on = both(wanted, number < steps);
            if (!any(on)) return;
            auto const along = floor(fma(number, step, -reach) + 0.5f), part = along / reach;
            // Every rounding is spelled out: where it ends decides which pixel is looked at.
            auto const aside = fma(part * part * bent, Real(-4.f), along * slope);
            auto const first = floor(select(slanted, aside, aside + 0.5f));
            // The pixel itself is no part of it.
            visit(offset(along, first), both(on, abs(along) + abs(first) > Real(0.5f)));
            if (auto const twice = both(on, slanted); any(twice))
                visit(offset(along, first + 1.f), both(twice, abs(along) + abs(first + 1.f) > Real(0.5f)));
        }
    }

private:
    QUELL_KERNEL vec2<Real> offset(Real along, Real aside) const { return {select(steep, aside, along), select(steep, along, aside)}; }
};
} // namespace detail

/// Gathers the samples that pass each pixel while the shutter is open, in two layers: of the two things that meet around the pixel, how
/// much of the time the one in front covers it, and what of it is seen meanwhile; and what is seen of the one behind. The coverage is the
/// part of all samples along the front's motion that show it. Samples are tested by their own paths; one counts for as long as it takes to
/// pass, as a fast one has more pixels to be seen in. What stands still keeps its value to the last bit.
/// Emits MovingLayer (the front), BackLayer, and MeanSweep of the back: 0 where it stands still, longer than any sweep where nothing is
/// known. Wants MotionPairs before it.
/// @tparam Signal the pipeline's
/// @tparam Paths  StraightPaths or BentPaths, as the MotionPairs'
template <ChannelTag Signal, class Paths = StraightPaths> struct PairGather {
    static constexpr auto name = "pair gather";
    static constexpr bool leaves_signal = true;
    using reads = decltype(Channels<Depth, MotionPair<Paths>>{} | reads_of<Paths>{});
    using emits = Channels<MovingLayer<Signal>, BackLayer<Signal>, MeanSweep>;
    int count = 96;                ///< samples looked at; with two motions, half of them along each
    float width = 1.f;             ///< pixels; a sample counts less the farther it passes, and not at all from here on
    float depth_tolerance = 0.02f; ///< how much farther, relatively, something is that stands behind something else
    int tile_width = 8, tile_height = 2; ///< pixels that share their lines, which makes neighbours' samples neighbours in memory

    template <class Px> QUELL_KERNEL auto emit(Px const& px) const {
        using Real = typename Px::Real;
        Work<Px> work(*this, px);
        if (any(either(work.two, work.back_moves))) work.gather(*this, px);
        return work.result(*this, px);
    }

private:
    template <class Px> struct Work {
        using Real = typename Px::Real;
        using Mover = detail::Mover<Paths, Real>;
        using Mask = decltype(Real(0.f) < Real(0.f));
        using Colour = typename Px::Signal;
        static constexpr int n = Signal::components;
        Mover front, back, own;
        Mask two, back_moves, own_in_front, own_still;
        Real per_difference, per_gap;
        detail::PartSums<Value<n + 2, Real>> in_front; ///< signal of the front, its weight, and the weight of all
        detail::PartSums<Value<n + 1, Real>> behind;
        vec2<Real> swept{Real(0.f), Real(0.f)};
        Real weights = Real(0.f), samples = Real(0.f);

        QUELL_KERNEL Work(PairGather const& g, Px const& px) : Work(px, px.elsewhere(g.shared(px), MotionPair<Paths>{})) {}
        template <class Pair>
        QUELL_KERNEL Work(Px const& px, Pair const& pair)
            : front(detail::one_of<0>(pair)), back(detail::one_of<1>(pair)), own(detail::mover_here<Paths>(px)),
              two(detail::depth_of(front) > Real(0.f)), back_moves(detail::squared_speed(back) > Real(least_squared)),
              in_front(sqrt(detail::squared_speed(front))), behind(sqrt(detail::squared_speed(back))) {
            per_difference = 1.f / max(sqrt(detail::squared_difference(front, back)), Real(1e-6f));
            per_gap = 1.f / max(abs(1.f / detail::depth_of(front) - 1.f / detail::depth_of(back)), Real(1e-9f));
            own_in_front = is_front(own);
            own_still = detail::squared_speed(own) <= Real(least_squared);
        }
        static constexpr float least_squared = Path<float>::least * Path<float>::least;

        /// Whether something is more like what is in front than like what is behind, by its motion and depth.
        QUELL_KERNEL Mask is_front(Mover const& m) const {
            auto const nearness = 1.f / detail::depth_of(m);
            auto const to_front = fma(sqrt(detail::squared_difference(m, front)), per_difference,
                                      abs(nearness - 1.f / detail::depth_of(front)) * per_gap);
            auto const to_back = fma(sqrt(detail::squared_difference(m, back)), per_difference,
                                     abs(nearness - 1.f / detail::depth_of(back)) * per_gap);
            return both(two, to_front < to_back);
        }

        QUELL_KERNEL void gather(PairGather const& g, Px const& px) {
            Real const zero(0.f);
            look(g, px, {zero, zero}, either(two, back_moves), two);
            int const half = g.count / 2;
            if (any(two)) {
                detail::LineOfPixels<Real> const line(detail::speed_of(front), bend_of(front), all_of(back_moves) ? half : g.count);
                line.for_each(two, [&](auto const& offset, auto on) __attribute__((always_inline)) { look(g, px, offset, on, two); });
            }
            if (any(back_moves)) {
                detail::LineOfPixels<Real> const line(detail::speed_of(back), bend_of(back), any(two) ? half : g.count);
                line.for_each(back_moves, [&](auto const& offset, auto on)
                                              __attribute__((always_inline)) { look(g, px, offset, on, invert(on)); });
            }
        }
        QUELL_KERNEL static bool all_of(Mask m) { return !any(invert(m)); }
        template <class M> QUELL_KERNEL static vec2<Real> bend_of([[maybe_unused]] M const& mover) {
            if constexpr (Paths::bent)
                return {component<3>(mover), component<4>(mover)};
            else
                return {Real(0.f), Real(0.f)};
        }

        /// Adds the sample at an offset to both layers, as far as it is wanted.
        QUELL_KERNEL void look(PairGather const& g, Px const& px, vec2<Real> const& offset, Mask wanted, Mask for_front) {
            auto const p = px.position();
            PixelUnder<Px> const there(px, {p.x + offset.x, p.y + offset.y});
            auto const path = Paths::there(px, there.place);
            auto const [value, missing] = px.signal_elsewhere(there.place);
            auto const mover = detail::mover_of<Paths>(path, px.elsewhere(there.place, depth));
            auto const usable = both(wanted, there.inside, invert(missing));
            vec2<Real> const away{-offset.x, -offset.y};
            auto const shows_front = is_front(mover);
            if (auto const counts = both(usable, for_front); any(counts)) add_front(g, value, path, mover, away, shows_front, counts);
            auto const counts = both(usable, invert(shows_front), path.moves());
            if (any(counts)) add_back(g, value, path, away, counts);
        }
        /// What shows something else is looked at as if it moved like the front: how many samples there are in all must not depend on what
        /// they show.
        QUELL_KERNEL void add_front(PairGather const& g, Colour const& value, auto const& path, Mover const& mover, vec2<Real> const& away,
                                    Mask shows_front, Mask counts) {
            auto const looked_at = moving_as(shows_front, path, like_front(path.time));
            auto const passing = looked_at.passing(away);
            auto const w = select(counts, weight(g, passing) / max(looked_at.length(), Real(Path<Real>::least)), Real(0.f));
            auto const hidden = both(own_still, invert(own_in_front),
                                     detail::hidden_behind(detail::depth_of(mover), detail::depth_of(own), g.depth_tolerance));
            auto const seen = select(both(shows_front, invert(hidden)), w, Real(0.f));
            in_front.add(make_value<n + 2, Real>([&](auto c) __attribute__((always_inline)) {
                if constexpr (c < n)
                    return component<c>(value) * seen;
                else if constexpr (c == n)
                    return seen;
                else
                    return w;
            }), clamp(passing.when, Real(0.f), Real(1.f)));
        }
        QUELL_KERNEL void add_back(PairGather const& g, Colour const& value, auto const& path, vec2<Real> const& away, Mask counts) {
            auto const passing = path.passing(away);
            auto const near = select(counts, weight(g, passing), Real(0.f));
            auto const w = near / max(path.length(), Real(Path<Real>::least));
            behind.add(detail::layer_of(scale(value, w), w), clamp(passing.when, Real(0.f), Real(1.f)));
            swept = add_scaled(swept, path.sweep, w);
            weights = weights + w;
            samples = samples + near;
        }
        QUELL_KERNEL static Real weight(PairGather const& g, auto const& passing) {
            return select(passing.in_time(), max(1.f - passing.distance / g.width, Real(0.f)), Real(0.f));
        }
        QUELL_KERNEL auto like_front(Real time) const {
            using PathType = decltype(Paths::here(std::declval<Px const&>()));
            if constexpr (Paths::bent)
                return PathType::at_speed(detail::speed_of(front), bend_of(front), time);
            else
                return PathType::at_speed(detail::speed_of(front), time);
        }

        QUELL_KERNEL auto result(PairGather const& g, Px const& px) const {
            constexpr float nowhere = 4.f * Path<float>::longest;
            auto const seen = invert(px.missing());
            auto const still_here = both(seen, own_still, invert(own_in_front));
            auto const found = both(invert(still_here), weights > Real(0.f));
            auto const inverse = 1.f / max(weights, Real(1e-12f));
            auto layer = detail::layer_of(select(still_here, px.signal(), behind.mean()),
                                          select(still_here, Real(BackLayer<Signal>::certain), select(found, samples, Real(0.f))));
            vec2<Real> sweep{select(found, swept.x * inverse, Real(0.f)), select(found, swept.y * inverse, Real(0.f))};
            auto const covered = invert(either(still_here, found));
            if (any(covered)) {
                layer = select(covered, g.guessed(px, covered), layer);
                auto const nothing = both(covered, detail::weight_of(layer) <= Real(0.f));
                sweep = select(nothing, vec2<Real>{Real(nowhere), Real(nowhere)}, sweep);
            }
            return emitted<Real>(MovingLayer<Signal>{}, in_front.mean()).with(BackLayer<Signal>{}, layer).with(mean_sweep, sweep);
        }
    };

    /// The pixel whose pair a tile shares.
    template <class Px> QUELL_KERNEL auto shared(Px const& px) const {
        using Real = typename Px::Real;
        auto const p = px.position();
        auto const anchor = [](Real at, int size, float within) __attribute__((always_inline)) {
            auto const tile = floor(at / static_cast<float>(size));
            return min(fma(tile, Real(static_cast<float>(size)), Real(static_cast<float>(size / 2))), Real(within - 1.f));
        };
        return PastPlace<Real>(anchor(p.x, tile_width, static_cast<float>(px.size().width)),
                               anchor(p.y, tile_height, static_cast<float>(px.size().height)));
    }
    /// The mean of what stands still in the 5x5 around, and behind what moves here. Outlined: few pixels are covered.
    template <class Px, class Mask> [[gnu::noinline]] constexpr auto guessed(Px const& px, Mask) const {
        using Real = typename Px::Real;
        auto sum = zero<typename Px::Signal>();
        Real weights(0.f);
        auto const own_depth = detail::usable_depth(px[depth]);
        for_each_neighbour<2>(
            px, [&](auto near, auto inside, int, int) __attribute__((always_inline)) {
                auto const before = detail::hidden_behind(own_depth, near[depth], depth_tolerance);
                auto const counts = both(invert(Paths::here(near).moves()), invert(near.missing()), invert(before));
                auto const w = select(counts, inside, Real(0.f));
                sum = add_scaled(sum, near.signal(), w);
                weights = weights + w;
            });
        return detail::layer_of(scale(sum, 1.f / max(weights, Real(1.f))),
                                select(weights > Real(0.f), Real(BackLayer<Signal>::guessed), Real(0.f)));
    }
};

} // namespace quell
