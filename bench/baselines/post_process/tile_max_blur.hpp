#pragma once

#include <baselines/pixel_under.hpp>
#include <quell/blur/trajectory/trajectory.hpp>
#include <quell/filter/filter_kernel.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Longest sweep that may reach a pixel, in pixels; 0 where none does.
struct DominantSweep : InternalChannel<2> {
    static constexpr auto name = "dominant_sweep";
};
/// The channel DominantSweep.
inline constexpr DominantSweep dominant_sweep;

namespace detail {
/// Longest of the sweeps here and one step away to either side. At borders the step is shorter, so that the window has no gaps.
/// @tparam From the channel of the sweeps
template <ChannelTag From> struct LongestSweep {
    static constexpr auto name = "longest sweep";
    static constexpr bool leaves_signal = true;
    using reads = Channels<From>;
    using emits = Channels<DominantSweep>;
    int right, down; ///< the step, in pixels

    constexpr int farthest_tap() const { return right > down ? right : down; }

    template <class Px> QUELL_KERNEL auto emit_channels(Px const& px) const {
        using Real = typename Px::Real;
        auto longest = Trajectory<Real>::of(px[From{}], Real(0.5f));
        auto const take_longer = [&](float sign) QUELL_INLINED {
            auto const path = Trajectory<Real>::of(px.elsewhere(place(px, sign), From{}), Real(0.5f));
            auto const longer = path.squared > longest.squared;
            longest.sweep = select(longer, path.sweep, longest.sweep);
            longest.squared = select(longer, path.squared, longest.squared);
        };
        take_longer(-1.f);
        take_longer(1.f);
        return emitted<Real>(dominant_sweep, longest.sweep);
    }

private:
    template <class Px> QUELL_KERNEL auto place(Px const& px, float sign) const {
        using Real = typename Px::Real;
        auto const p = px.position();
        Real const last_column(to_real(px.size().width - 1)), last_row(to_real(px.size().height - 1));
        return PixelCoordinates<Real>(clamp(p.x + (sign * static_cast<float>(right) - 0.5f), Real(0.f), last_column),
                                      clamp(p.y + (sign * static_cast<float>(down) - 0.5f), Real(0.f), last_row));
    }
};

/// Third pass of McGuire et al. 2012: samples along the dominant sweep, weighted by their own sweeps and depths.
struct TileMaxGather {
    static constexpr auto name = "tile-max blur";
    using reads = Channels<Sweep, Depth, DominantSweep>;
    int samples;
    float longest;
    float depth_extent;

    template <class Px> QUELL_KERNEL typename Px::Signal filter(Px const& px) const {
        using Real = typename Px::Real;
        auto const own = px.signal();
        auto const dominant = half(px[dominant_sweep]);
        auto const blurred = dominant.length > Real(shortest);
        if (!any(blurred)) return own;
        auto const here = look(px[sweep], px[depth]);
        auto const p = px.position();
        auto const jitter = px.random_uniforms().first - 0.5f;
        // The longer a surface's sweep, the less its own colour counts at one pixel.
        auto weights = select(px.missing(), Real(0.f), 1.f / here.radius);
        auto sum = scale(own, weights);
        for (int i = 0; i < samples; ++i) {
            if (2 * i + 1 == samples) continue;
            auto const part = fma(jitter + static_cast<float>(i + 1), Real(2.f / static_cast<float>(samples + 1)), Real(-1.f));
            PixelUnder<Px> const under(px, {fma(dominant.sweep.x, part, p.x), fma(dominant.sweep.y, part, p.y)});
            auto const there = look(px.elsewhere(under.place, sweep), px.elsewhere(under.place, depth));
            auto const [value, missing] = px.signal_elsewhere(under.place);
            auto const x = under.column - p.x + 0.5f, y = under.row - p.y + 0.5f;
            auto const w = masked(both(under.inside, invert(missing)), weight(here, there, sqrt(fma(x, x, y * y))));
            sum = add_scaled(sum, value, w);
            weights = weights + w;
        }
        return select(both(blurred, weights > Real(0.f)), scale(sum, 1.f / max(weights, Real(1e-30f))), own);
    }

private:
    static constexpr float shortest = 0.5f; ///< half of a sweep, in pixels: a shorter one stays within its pixel

    /// Half of a sweep, from the middle of the shutter to its end, clamped to the reach of the blur.
    template <class Real> struct Half {
        vec2<Real> sweep;
        Real length;
    };
    template <class Real> QUELL_KERNEL Half<Real> half(vec2<Real> const& whole) const {
        auto const path = Trajectory<Real>::of(whole, Real(0.5f));
        auto const length = path.length();
        auto const part = min(longest / max(length, Real(1e-6f)), Real(0.5f));
        return {scale(path.sweep, part), length * part};
    }
    /// Depth, and how far the surface sweeps to either side in pixels.
    template <class Real> struct Seen { Real depth, radius; };
    template <class Real> QUELL_KERNEL Seen<Real> look(vec2<Real> const& whole, Real z) const {
        constexpr float nearest = 1e-6f, farthest = 1e30f;
        auto const known = select(is_finite(z), clamp(z, Real(nearest), Real(farthest)), Real(farthest));
        return {known, max(half(whole).length, Real(shortest))};
    }

    /// Weight of a sample: of a blurred surface in front of this pixel's; of the background behind a blurred surface here, as a guess; and
    /// of both where they sweep over each other.
    template <class Real> QUELL_KERNEL Real weight(Seen<Real> const& here, Seen<Real> const& there, Real distance) const {
        auto const before = not_behind(there.depth, here.depth) * cone(distance, there.radius);
        auto const behind = not_behind(here.depth, there.depth) * cone(distance, here.radius);
        return before + behind + cylinder(distance, there.radius) * cylinder(distance, here.radius) * 2.f;
    }
    /// 1 where a is no farther than b, falling to 0 with the distance.
    template <class Real> QUELL_KERNEL Real not_behind(Real a, Real b) const {
        return clamp(1.f - (a - b) / (min(a, b) * depth_extent), Real(0.f), Real(1.f));
    }
    template <class Real> QUELL_KERNEL static Real cone(Real distance, Real radius) { return max(1.f - distance / radius, Real(0.f)); }
    /// 1 within the radius, 0 outside, smooth over a twentieth of it to either side.
    template <class Real> QUELL_KERNEL static Real cylinder(Real distance, Real radius) {
        auto const t = clamp((distance / radius - 0.95f) * 10.f, Real(0.f), Real(1.f));
        return 1.f - t * t * (3.f - t * 2.f);
    }
};
} // namespace detail

/// Motion blur of a sharp picture beyond the outlines of moving surfaces: samples along the longest sweep around, weighted by their own
/// sweeps and by depth (McGuire et al. 2012, A Reconstruction Filter for Plausible Motion Blur). It does not know what was hidden in the
/// middle of the shutter. "Around" is a window of the blur's reach, where the paper takes the 3x3 tiles around the pixel's own; it lies
/// within these, has all that can matter, and shows no tile borders.
/// Needs the signal at the middle of the open shutter. Where nothing moves, the signal keeps every bit.
struct TileMaxBlur {
    using reads = Channels<Sweep, Depth>;
    using emits = Channels<DominantSweep>;
    int tile = 20;    ///< reach of the blur in pixels, at least 1; longer sweeps are clamped to twice that
    int samples = 15; ///< along the dominant sweep, including the pixel itself; odd
    /// relative difference of depth from which on a surface is wholly behind another; the paper has a length instead
    float depth_extent = 0.02f;

    constexpr void for_each_pass(auto&& pass) const {
        pass(detail::LongestSweep<Sweep>{1, 0});
        widen(1, [&](int step) { pass(detail::LongestSweep<DominantSweep>{step, 0}); });
        widen(0, [&](int step) { pass(detail::LongestSweep<DominantSweep>{0, step}); });
        pass(detail::TileMaxGather{samples, static_cast<float>(tile), depth_extent});
    }

private:
    /// Calls by(step) until a window of half width `reached` has the half width `tile`. A step may be as long as the window is wide.
    constexpr void widen(int reached, auto&& by) const {
        for (int step = 0; reached < tile; reached += step) {
            int const width = 2 * reached + 1, rest = tile - reached;
            step = width < rest ? width : rest;
            by(step);
        }
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
