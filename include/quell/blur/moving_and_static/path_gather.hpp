#pragma once

#include <quell/blur/guessed_layer.hpp>
#include <quell/blur/pixel_under.hpp>
#include <quell/blur/trajectory/path_weight.hpp>

namespace quell {

/// Where to look for samples that may pass a pixel: stratified along the line, or arc, along which things move around, as far as they
/// sweep.
template <class Paths = StraightPaths> struct AlongGuide {
    using reads = std::conditional_t<Paths::bent, Channels<GuideAxis, GuideBend>, Channels<GuideAxis>>;
    int count = 24;
    float across = 1.f; ///< how far from the line, in pixels, to either side

    template <class Px> struct Places {
        using Real = typename Px::Real;
        vec2<Real> centre, axis, beside, bend;
        Real first, second; ///< random in [0, 1)
        float spacing, across;

        // Every rounding is spelled out: where it ends decides which pixel is looked at.
        QUELL_KERNEL vec2<Real> at(int i) const {
            auto const number = Real(static_cast<float>(i));
            auto const stratum = fraction(fma(number, Real(0.618034f), first)) + number;
            auto const along = fma(stratum, Real(2.f * spacing), Real(-1.f));
            auto const aside = fma(fraction(fma(number, Real(0.7548777f), second)), Real(2.f * across), Real(-across));
            vec2<Real> const on_line{fma(beside.x, aside, fma(axis.x, along, centre.x)),
                                     fma(beside.y, aside, fma(axis.y, along, centre.y))};
            if constexpr (!Paths::bent) return on_line;
            // A path that goes through here: to second order, on whichever side it was sampled.
            auto const bent = along * along * -4.f;
            return {fma(bend.x, bent, on_line.x), fma(bend.y, bent, on_line.y)};
        }
        QUELL_KERNEL static Real fraction(Real a) { return a - floor(a); }
    };
    template <class Px> QUELL_KERNEL Places<Px> places(Px const& px) const {
        using Real = typename Px::Real;
        auto const axis = px[guide_axis];
        auto const inverse = 1.f / max(sqrt(fma(axis.x, axis.x, axis.y * axis.y)), Real(1e-6f));
        auto const [first, second] = px.random_uniforms();
        return {px.position(), axis,   {-axis.y * inverse, axis.x * inverse}, bend(px),
                first,         second, 1.f / static_cast<float>(count),       across};
    }

private:
    template <class Px> QUELL_KERNEL static vec2<typename Px::Real> bend([[maybe_unused]] Px const& px) {
        if constexpr (Paths::bent)
            return px[guide_bend];
        else
            return zero<vec2<typename Px::Real>>();
    }
};

/// Gathers samples from all over the image that pass each pixel while the shutter is open, and makes the two layers of them: the mean
/// of what moves, how much of the time it covers the pixel, and what stands still there. A sample counts for as long as it takes to pass:
/// a fast one has more pixels to be seen in. What stands still keeps its value to the last bit; where it is covered it is guessed from the
/// pixels around. (After MB sections 4.2 and 4.3.)
/// Emits MovingLayer, StaticLayer and MeanSweep; leaves the signal alone. Wants a MotionGuide before it.
/// @tparam S the pipeline's signal
/// @tparam Paths StraightPaths or BentPaths, as the MotionGuide's
/// @tparam Places where it looks
template <ChannelTag S, class Paths = StraightPaths, class Places = AlongGuide<Paths>> struct PathGather {
    using Signal = S;
    static constexpr auto name = "path gather";
    static constexpr bool leaves_signal = true;
    using parts = Parts<Paths, Places, PathWeight>;
    using reads = Channels<Depth, GuideSweep, GuideAxis>;
    using emits = Channels<MovingLayer<Signal>, StaticLayer<Signal>, MeanSweep>;
    Places where{};
    PathWeight weight{};
    float depth_tolerance = 0.02f; ///< how much farther, relatively, something is that stands behind something else

    template <class Px> QUELL_KERNEL auto emit_channels(Px const& px) const {
        using Real = typename Px::Real;
        auto const own = Paths::here(px);
        auto const around = px[guide_sweep];
        auto const z = px[depth];
        auto const signal = px.signal();
        auto const seen = invert(px.missing());
        auto const guide = guide_path(px);
        Gathered<Px> sums(guide.length());
        if (any(px[guide_spread].z > Real(0.f))) {
            auto const reach = weight.reach(px);
            auto const share = select(own.moves(), guide.length() / max(own.length(), Real(Path<Real>::least)), Real(1.f));
            sums.add(signal, own, masked(seen, share), own.moves(), own.time);
            auto const places = where.places(px);
            for (int i = 0; i < where.count; ++i) add_sample(px, sums, places.at(i), own, guide, z, reach);
        }
        auto const found = sums.swept > Real(0.f);
        auto const inverse = 1.f / max(sums.swept, Real(1e-6f));
        vec2<Real> const swept{select(found, sums.sweep.x * inverse, around.x), select(found, sums.sweep.y * inverse, around.y)};
        auto const still_here = both(seen, invert(own.moves()));
        auto still = detail::layer_of(select(still_here, signal, zero<typename Px::Signal>()), masked(still_here, Real(1.f)));
        if (any(invert(still_here))) still = select(still_here, still, guessed(px, z, own.moves()));
        return emitted<Real>(MovingLayer<Signal>{}, sums.mean()).with(StaticLayer<Signal>{}, still).with(mean_sweep, swept);
    }

private:
    /// How things move around.
    template <class Px> QUELL_KERNEL static auto guide_path(Px const& px) {
        using Real = typename Px::Real;
        auto const straight = Path<Real>::of(px[guide_axis], Real(0.5f));
        if constexpr (Paths::bent)
            return BentPath<Real>::of(straight, px[guide_bend]);
        else
            return straight;
    }
    /// Sums over samples, by when they pass: the mean of the means of equal parts of the open shutter has less noise than the mean of all.
    template <class Px> struct Gathered {
        using Real = typename Px::Real;
        static constexpr int parts = 8; ///< at most: they are as long as it takes to pass `pixels_a_part`
        static constexpr float pixels_a_part = 4.f;
        struct Part {
            typename Px::Signal signal = zero<typename Px::Signal>(); ///< of what moves
            Real weight = Real(0.f), all = Real(0.f);
        };
        Real count; ///< of parts, from 1
        Part part[parts];
        vec2<Real> sweep{Real(0.f), Real(0.f)};
        Real swept = Real(0.f);

        QUELL_KERNEL explicit Gathered(Real length)
            : count(floor(clamp(length * (1.f / pixels_a_part), Real(1.f), Real(static_cast<float>(parts))))) {}
        QUELL_KERNEL void add(typename Px::Signal const& value, auto const& path, Real w, auto moves, Real when) {
            auto const counted = masked(moves, w);
            sweep = add_scaled(sweep, path.sweep, counted);
            swept = swept + counted;
            // The end of the last part belongs to it.
            auto const which = min(floor(when * count), count - 1.f);
            for (int i = 0; i < parts; ++i) {
                auto const here = abs(which - static_cast<float>(i)) < Real(0.5f);
                auto const all_here = masked(here, w), counted_here = masked(here, counted);
                part[i].all = part[i].all + all_here;
                part[i].weight = part[i].weight + counted_here;
                part[i].signal = add_scaled(part[i].signal, value, counted_here);
            }
        }
        QUELL_KERNEL auto mean() const {
            auto sum = zero<Value<Signal::components + 1, Real>>();
            Real known(0.f);
            for (auto const& p : part) {
                auto const some = p.all > Real(0.f);
                auto const inverse = masked(some, 1.f / max(p.all, Real(1e-6f)));
                sum = add_scaled(sum, detail::layer_of(p.signal, p.weight), inverse);
                known = known + masked(some, Real(1.f));
            }
            return scale(sum, 1.f / max(known, Real(1.f)));
        }
    };
    /// What stands still is looked at as if it moved like all around it: how many samples there are in all must not depend on what they
    /// show.
    template <class Px, class Real, class PathOf>
    QUELL_KERNEL void add_sample(Px const& px, Gathered<Px>& sums, vec2<Real> const& at, PathOf const& own, PathOf const& guide,
                                 Real own_depth, Real reach) const {
        PixelUnder<Px> const there(px, at);
        auto const path = Paths::there(px, there.place);
        auto const [value, missing] = px.signal_elsewhere(there.place);
        auto const hidden = both(invert(own.moves()), detail::hidden_behind(px.elsewhere(there.place, depth), own_depth, depth_tolerance));
        auto const moves = both(path.moves(), invert(hidden));
        auto const looked_at = moving_as(path.moves(), path, guide);
        auto const centre = px.position();
        auto const passing = looked_at.passing({centre.x - there.column - 0.5f, centre.y - there.row - 0.5f});
        auto const usable = both(invert(missing), there.inside);
        auto const w = weight.weight(passing, reach) / max(looked_at.length(), Real(Path<Real>::least));
        sums.add(value, path, masked(usable, w * guide.length()), moves, passing.when);
    }
    /// What stands still behind what moves here.
    template <class Px, class Real, class Mask> QUELL_KERNEL auto guessed(Px const& px, Real own_depth, Mask own_moves) const {
        constexpr float guess = 0.05f;
        return detail::guessed_layer(px, guess, [&](auto const& neighbour) QUELL_INLINED {
            auto const before = both(own_moves, detail::hidden_behind(own_depth, neighbour[depth], depth_tolerance));
            return both(invert(Paths::here(neighbour).moves()), invert(neighbour.missing()), invert(before));
        });
    }
};

} // namespace quell
