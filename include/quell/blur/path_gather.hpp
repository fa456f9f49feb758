#pragma once

#include <quell/blur/layers.hpp>
#include <quell/blur/path_weight.hpp>
#include <quell/blur/pixel_under.hpp>

namespace quell {

/// Where to look for samples that may pass a pixel: stratified along the line along which things move around, as far as they sweep.
struct AlongGuide {
    using reads = Channels<GuideAxis>;
    int count = 24;
    float across = 1.f; ///< how far from the line, in pixels, to either side

    template <class Px> struct Places {
        using Real = typename Px::Real;
        vec2<Real> centre, axis, beside;
        Real first, second; ///< random in [0, 1)
        float spacing, across;

        // Every rounding is spelled out: where it ends decides which pixel is looked at.
        QUELL_KERNEL vec2<Real> at(Px const&, int i) const {
            auto const number = Real(static_cast<float>(i));
            auto const stratum = fraction(fma(number, Real(0.618034f), first)) + number;
            auto const along = fma(stratum, Real(2.f * spacing), Real(-1.f));
            auto const aside = fma(fraction(fma(number, Real(0.7548777f), second)), Real(2.f * across), Real(-across));
            return {fma(beside.x, aside, fma(axis.x, along, centre.x)), fma(beside.y, aside, fma(axis.y, along, centre.y))};
        }
        QUELL_KERNEL static Real fraction(Real a) { return a - floor(a); }
    };
    template <class Px> QUELL_KERNEL Places<Px> places(Px const& px) const {
        using Real = typename Px::Real;
        auto const axis = px[guide_axis];
        auto const inverse = 1.f / max(sqrt(fma(axis.x, axis.x, axis.y * axis.y)), Real(1e-6f));
        auto const [first, second] = px.random_uniforms();
        return {px.position(), axis, {-axis.y * inverse, axis.x * inverse}, first, second, 1.f / static_cast<float>(count), across};
    }
};

/// Gathers samples from all over the image that pass each pixel while the shutter is open, and makes the two layers of them: the mean
/// of what moves, how much of the time it covers the pixel, and what stands still there. A sample counts for as long as it takes to pass:
/// a fast one has more pixels to be seen in. What stands still keeps its value to the last bit; where it is covered it is guessed from the
/// pixels around. (After MB sections 4.2 and 4.3.)
/// Emits MovingLayer, StaticLayer and MeanSweep; leaves the signal alone. Wants a MotionGuide before it.
/// @tparam Signal the pipeline's
/// @tparam Places where it looks
template <ChannelTag Signal, class Places = AlongGuide> struct PathGather {
    static constexpr auto name = "path gather";
    static constexpr bool leaves_signal = true;
    using reads = decltype(Channels<Sweep, Time, Depth, GuideSweep, GuideAxis>{} | reads_of<Places, PathWeight>{});
    using emits = Channels<MovingLayer<Signal>, StaticLayer<Signal>, MeanSweep>;
    Places where{};
    PathWeight weight{};
    float depth_tolerance = 0.02f; ///< how much farther, relatively, something is that stands behind something else

    template <class Px> QUELL_KERNEL auto emit(Px const& px) const {
        using Real = typename Px::Real;
        auto const own = Path<Real>::of(px[sweep], px[time]);
        auto const around = px[guide_sweep];
        auto const z = px[depth];
        auto const signal = px.signal();
        auto const seen = invert(px.missing());
        Gathered<Px> sums;
        auto const guide = Path<Real>::of(px[guide_axis], Real(0.5f));
        auto const spread = px[guide_spread];
        auto const near_motion = spread.z > Real(0.f);
        if (any(near_motion)) {
            auto const reach = weight.reach(px);
            auto const share = select(own.moves(), guide.length() / max(own.length(), Real(Path<Real>::least)), Real(1.f));
            sums.add(signal, own, select(seen, share, Real(0.f)), own.moves());
            auto const places = where.places(px);
            for (int i = 0; i < where.count; ++i) {
                auto const place = places.at(px, i);
                add_sample(px, sums, place, own, guide, z, reach);
            }
        }
        auto const moving = near_motion;
        auto const coverage = select(both(moving, sums.all > Real(0.f)), sums.weight / max(sums.all, Real(1e-6f)), Real(0.f));
        auto const inverse = select(sums.weight > Real(0.f), 1.f / max(sums.weight, Real(1e-6f)), Real(0.f));
        auto const found = both(moving, sums.weight > Real(0.f));
        vec2<Real> const mean{select(found, sums.sweep.x * inverse, around.x), select(found, sums.sweep.y * inverse, around.y)};
        auto const mean_signal = scale(sums.signal, inverse * coverage);
        auto const still_here = both(seen, invert(own.moves()));
        auto still = detail::layer_of(select(still_here, signal, zero<typename Px::Signal>()), select(still_here, Real(1.f), Real(0.f)));
        if (any(invert(still_here))) still = select(still_here, still, guessed(px, z, own.moves()));
        return emitted<Real>(MovingLayer<Signal>{}, detail::layer_of(select(moving, mean_signal, zero<typename Px::Signal>()), coverage))
            .with(StaticLayer<Signal>{}, still)
            .with(mean_sweep, mean);
    }

private:
    template <class Px> struct Gathered {
        using Real = typename Px::Real;
        typename Px::Signal signal = zero<typename Px::Signal>(); ///< of what moves
        vec2<Real> sweep{Real(0.f), Real(0.f)};
        Real weight = Real(0.f), all = Real(0.f);

        QUELL_KERNEL void add(typename Px::Signal const& value, Path<Real> const& path, Real w, auto moves) {
            auto const counted = select(moves, w, Real(0.f));
            all = all + w;
            weight = weight + counted;
            signal = add_scaled(signal, value, counted);
            sweep = add_scaled(sweep, path.sweep, counted);
        }
    };
    /// What stands still is looked at as if it moved like all around it: how many samples there are in all must not depend on what they
    /// show.
    template <class Px, class Real>
    QUELL_KERNEL void add_sample(Px const& px, Gathered<Px>& sums, vec2<Real> const& at, Path<Real> const& own, Path<Real> const& guide,
                                 Real own_depth, Real reach) const {
        PixelUnder<Px> const there(px, at);
        auto const path = Path<Real>::of(px.elsewhere(there.place, quell::sweep), px.elsewhere(there.place, time));
        auto const [value, missing] = px.signal_elsewhere(there.place);
        auto const hidden = both(invert(own.moves()), detail::hidden_behind(px.elsewhere(there.place, depth), own_depth, depth_tolerance));
        auto const moves = both(path.moves(), invert(hidden));
        Path<Real> const looked_at{select(path.moves(), path.sweep, guide.sweep), path.time,
                                   select(path.moves(), path.squared, guide.squared)};
        auto const centre = px.position();
        auto const passing = looked_at.passing({centre.x - there.column - 0.5f, centre.y - there.row - 0.5f});
        auto const usable = both(invert(missing), there.inside);
        auto const w = weight.weight(passing, reach) / max(looked_at.length(), Real(Path<Real>::least));
        sums.add(value, path, select(usable, w * guide.length(), Real(0.f)), moves);
    }
    /// The mean of what stands still in the 5x5 around, and behind what moves here. Outlined: few pixels are covered.
    template <class Px, class Real, class Mask>
    [[gnu::noinline]] constexpr auto guessed(Px const& px, Real own_depth, Mask own_moves) const {
        auto sum = zero<typename Px::Signal>();
        Real weights(0.f);
        for_each_neighbour<2>(
            px, [&](auto near, auto inside, int, int) __attribute__((always_inline)) {
                auto const before = both(own_moves, detail::hidden_behind(own_depth, near[depth], depth_tolerance));
                auto const counts = both(invert(Path<Real>::of(near[sweep], Real(0.f)).moves()), invert(near.missing()), invert(before));
                auto const w = select(counts, inside, Real(0.f));
                sum = add_scaled(sum, near.signal(), w);
                weights = weights + w;
            });
        constexpr float guess = 0.05f;
        return detail::layer_of(scale(sum, 1.f / max(weights, Real(1.f))), select(weights > Real(0.f), Real(guess), Real(0.f)));
    }
};

} // namespace quell
