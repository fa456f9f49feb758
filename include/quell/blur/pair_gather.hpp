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
/// The mean of the means of equal parts of the open shutter, of samples that pass at their times: it has much less noise than the mean of
/// all, since times are random and crowd. Samples are held back until it is known how much each part has.
/// @tparam V what is averaged, times a weight; @tparam most samples, at most
template <class V, int most> struct PartMeans {
    using Real = real_of<V>;
    static constexpr int most_parts = 8; ///< they are as long as it takes to pass `pixels_a_part`, at least
    static constexpr float pixels_a_part = 2.f;
    struct Held {
        V value;
        Real part;
    };
    Real count;              ///< of parts, from 1
    Real weight[most_parts]; ///< of all samples in each
    Held held[most];
    int size = 0;

    QUELL_KERNEL explicit PartMeans(Real pixels)
        : count(floor(clamp(pixels * (1.f / pixels_a_part), Real(1.f), Real(static_cast<float>(most_parts))))) {
        for (auto& w : weight) w = Real(0.f);
    }
    /// @param weighted the value times its weight, @param w the weight that counts in the mean, @param when in [0, 1]
    QUELL_KERNEL void add(V const& weighted, Real w, Real when) {
        if (!any(w > Real(0.f)) || size == most) return;
        // The end of the last part belongs to it.
        auto const part = min(floor(when * count), count - 1.f);
        for_each_part([&](auto i) __attribute__((always_inline)) { weight[i] = weight[i] + select(is(part, i), w, Real(0.f)); });
        held[size++] = Held{weighted, part};
    }
    QUELL_KERNEL V mean() const {
        Real share[most_parts], known(0.f);
        for (int i = 0; i < most_parts; ++i) {
            auto const some = weight[i] > Real(0.f);
            share[i] = select(some, 1.f / max(weight[i], Real(1e-12f)), Real(0.f));
            known = known + select(some, Real(1.f), Real(0.f));
        }
        auto sum = zero<V>();
        for (int k = 0; k < size; ++k) {
            auto its = share[0];
            for_each_part([&](auto i) __attribute__((always_inline)) { its = select(is(held[k].part, i), share[i], its); });
            sum = add_scaled(sum, held[k].value, its);
        }
        return scale(sum, 1.f / max(known, Real(1.f)));
    }

private:
    QUELL_KERNEL static auto is(Real part, int i) { return part == Real(static_cast<float>(i)); }
    /// Unrolled, whatever the host's flags: a loop would make its constants anew each time.
    template <class Visit> QUELL_KERNEL static void for_each_part(Visit&& visit) {
        [&]<int... i>(std::integer_sequence<int, i...>) __attribute__((always_inline)) { (visit(std::integral_constant<int, i>{}), ...); }
        (std::make_integer_sequence<int, most_parts>{});
    }
};

/// The pixels along a line through a pixel to either side, as far as something moves while the shutter is open: all of them, or as many as
/// there is time for. A line that is not parallel to an axis passes between two pixels everywhere, and visits both.
struct LineOfPixels {
    bool steep, slanted;
    float slope, bent, reach, step;
    int steps;

    constexpr LineOfPixels(glm::vec2 const& speed, glm::vec2 const& bend, int budget)
        : steep(abs(speed.y) > abs(speed.x)), slanted(false), slope(0), bent(0), reach(0), step(0), steps(0) {
        float const major = steep ? speed.y : speed.x, minor = steep ? speed.x : speed.y;
        slope = minor / (abs(major) > 1e-6f ? major : 1.f);
        bent = fma(-slope, steep ? bend.y : bend.x, steep ? bend.x : bend.y);
        slanted = abs(slope) > 0.02f || abs(bent) > 0.1f;
        reach = floor(abs(major)) + 1.f;
        float const pixels = fma(reach, 2.f, 1.f), affordable = static_cast<float>(slanted ? budget / 2 : budget);
        steps = static_cast<int>(min(affordable, pixels));
        step = 2.f * reach / max(static_cast<float>(steps - 1), 1.f);
    }
    /// Calls visit(dx, dy) for each but the pixel itself.
    template <class Visit> QUELL_KERNEL void for_each(Visit&& visit) const {
        for (int i = 0; i < steps; ++i) {
            // Every rounding is spelled out: where it ends decides which pixel is looked at.
            float const along = floor(fma(static_cast<float>(i), step, -reach) + 0.5f), part = along / reach;
            float const aside = fma(part * part * bent, -4.f, along * slope);
            int const a = static_cast<int>(along), first = static_cast<int>(floor(slanted ? aside : aside + 0.5f));
            for (int k = 0; k <= (slanted ? 1 : 0); ++k)
                if (int const b = first + k; a != 0 || b != 0) steep ? visit(b, a) : visit(a, b);
        }
    }
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
    static constexpr int most_samples = 128;
    int count = 96;                      ///< samples looked at, at most `most_samples`; with two motions, half of them along each
    float width = 1.f;                   ///< pixels; a sample counts less the farther it passes, and not at all from here on
    float bend_influence = 0.25f;        ///< per pixel of bend, how much wider that is, up to twice: what bends is known less exactly
    float depth_tolerance = 0.02f;       ///< how much farther, relatively, something is that stands behind something else
    int tile_width = 8, tile_height = 2; ///< pixels that share their lines, which makes neighbours' samples neighbours in memory

    template <class Px> QUELL_KERNEL auto emit(Px const& px) const {
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
        bool some_two;
        Real per_difference, per_gap;
        detail::PartMeans<Value<n + 1, Real>, most_samples + 1> in_front; ///< its signal and its coverage
        detail::PartMeans<Colour, most_samples + 1> behind;
        vec2<Real> swept{Real(0.f), Real(0.f)};
        Real weights = Real(0.f), samples = Real(0.f);

        QUELL_KERNEL Work(PairGather const& g, Px const& px) : Work(px, px.elsewhere(g.shared(px), MotionPair<Paths>{})) {}
        template <class Pair>
        QUELL_KERNEL Work(Px const& px, Pair const& pair)
            : front(detail::one_of<0>(pair)), back(detail::one_of<1>(pair)), own(detail::mover_here<Paths>(px)),
              two(detail::depth_of(front) > Real(0.f)), back_moves(detail::squared_speed(back) > Real(least_squared)),
              in_front(sqrt(detail::squared_speed(front))), behind(sqrt(detail::squared_speed(back))) {
            per_difference = 1.f / max(sqrt(detail::squared_difference(front, back)), Real(1e-6f));
            auto const far = max(detail::depth_of(front), detail::depth_of(back));
            auto const gap = abs(1.f / detail::depth_of(front) - 1.f / detail::depth_of(back));
            per_gap = select(gap * far > Real(least_gap), 1.f / max(gap, Real(1e-9f)), Real(0.f));
            some_two = any(two);
            own_in_front = some_two ? is_front(own) : two;
            own_still = detail::squared_speed(own) <= Real(least_squared);
        }
        static constexpr float least_gap = 0.02f; ///< relative; things nearer in depth are told apart by their motion alone
        static constexpr float least_squared = Path<float>::least * Path<float>::least;

        /// Whether something is more like what is in front than like what is behind, by its motion and depth.
        QUELL_KERNEL Mask is_front(Mover const& m) const {
            auto const nearness = 1.f / detail::depth_of(m);
            auto const to_front =
                fma(sqrt(detail::squared_difference(m, front)), per_difference, abs(nearness - 1.f / detail::depth_of(front)) * per_gap);
            auto const to_back =
                fma(sqrt(detail::squared_difference(m, back)), per_difference, abs(nearness - 1.f / detail::depth_of(back)) * per_gap);
            return both(two, to_front < to_back);
        }

        /// Tile by tile, of which a pack may meet several: within one, all pixels look at the same offsets, so that loads are of
        /// neighbours.
        QUELL_KERNEL void gather(PairGather const& g, Px const& px) {
            add(g, px, 0, 0, either(two, back_moves), two);
            auto const column = Real(static_cast<float>(px.x)) + lanes<Real>();
            for (int first = px.x; first < px.x + width_of<Real>;) {
                int const next = (first / g.tile_width + 1) * g.tile_width, k = first - px.x;
                auto const tile = both(column >= Real(static_cast<float>(first)), column < Real(static_cast<float>(next)));
                bool const in_two = lane(detail::depth_of(front), k) > 0.f;
                glm::vec2 const behind_speed = speed_in(back, k);
                bool const moves = dot(behind_speed, behind_speed) > least_squared;
                int const half = g.count / 2;
                if (in_two)
                    detail::LineOfPixels(speed_in(front, k), bend_in(front, k), moves ? half : g.count)
                        .for_each([&](int dx, int dy) __attribute__((always_inline)) { add(g, px, dx, dy, tile, tile); });
                if (moves)
                    detail::LineOfPixels(behind_speed, bend_in(back, k), in_two ? half : g.count)
                        .for_each([&](int dx, int dy) __attribute__((always_inline)) { add(g, px, dx, dy, tile, invert(tile)); });
                first = next;
            }
        }
        QUELL_KERNEL static glm::vec2 speed_in(Mover const& m, int k) { return {lane(component<0>(m), k), lane(component<1>(m), k)}; }
        QUELL_KERNEL static glm::vec2 bend_in([[maybe_unused]] Mover const& m, [[maybe_unused]] int k) {
            if constexpr (Paths::bent)
                return {lane(component<3>(m), k), lane(component<4>(m), k)};
            else
                return {0.f, 0.f};
        }
        template <class M> QUELL_KERNEL static vec2<Real> bend_of([[maybe_unused]] M const& mover) {
            if constexpr (Paths::bent)
                return {component<3>(mover), component<4>(mover)};
            else
                return {Real(0.f), Real(0.f)};
        }

        /// Adds the sample at an offset to both layers, as far as it is wanted.
        QUELL_KERNEL void add(PairGather const& g, Px const& px, int dx, int dy, Mask wanted, Mask for_front) {
            auto const there = px.at(dx, dy);
            if (!there.row_inside) return;
            auto const path = Paths::here(there);
            auto const mover = detail::mover_of<Paths>(path, there[depth]);
            auto const usable = both(wanted, there.inside(), invert(there.missing()));
            vec2<Real> const away{Real(static_cast<float>(-dx)), Real(static_cast<float>(-dy))};
            auto const shows_front = some_two ? is_front(mover) : two;
            if (auto const counts = both(usable, for_front); any(counts))
                add_front(g, there.signal(), path, mover, away, shows_front, counts);
            auto const counts = both(usable, invert(shows_front), path.moves());
            if (any(counts)) add_back(g, there.signal(), path, away, counts);
        }
        /// What shows something else is looked at as if it moved like the front: how many samples there are in all must not depend on what
        /// they show.
        QUELL_KERNEL void add_front(PairGather const& g, Colour const& value, auto const& path, Mover const& mover, vec2<Real> const& away,
                                    Mask shows_front, Mask counts) {
            auto const looked_at = moving_as(shows_front, path, like_front(path.time));
            auto const passing = looked_at.passing(away);
            auto const w = select(counts, weight(passing, width_for(g, front)) * looked_at.time_per_pixel(), Real(0.f));
            auto const hidden = both(own_still, invert(own_in_front),
                                     detail::hidden_behind(detail::depth_of(mover), detail::depth_of(own), g.depth_tolerance));
            auto const seen = select(both(shows_front, invert(hidden)), w, Real(0.f));
            in_front.add(detail::layer_of(scale(value, seen), seen), w, clamp(passing.when, Real(0.f), Real(1.f)));
        }
        QUELL_KERNEL void add_back(PairGather const& g, Colour const& value, auto const& path, vec2<Real> const& away, Mask counts) {
            auto const passing = path.passing(away);
            auto const near = select(counts, weight(passing, width_for(g, back)), Real(0.f));
            auto const w = near * path.time_per_pixel();
            behind.add(scale(value, w), w, clamp(passing.when, Real(0.f), Real(1.f)));
            swept = add_scaled(swept, path.sweep, w);
            weights = weights + w;
            samples = samples + near;
        }
        QUELL_KERNEL static Real weight(auto const& passing, Real width) {
            return select(passing.in_time(), max(1.f - passing.distance / width, Real(0.f)), Real(0.f));
        }
        QUELL_KERNEL static Real width_for(PairGather const& g, Mover const& mover) {
            if constexpr (Paths::bent) {
                auto const bend = bend_of(mover);
                return fma(min(sqrt(fma(bend.x, bend.x, bend.y * bend.y)) * g.bend_influence, Real(1.f)), Real(g.width), Real(g.width));
            } else
                return Real(g.width);
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
