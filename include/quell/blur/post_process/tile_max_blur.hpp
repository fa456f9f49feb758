#pragma once

#include <quell/blur/pixel_under.hpp>
#include <quell/blur/trajectory/path.hpp>
#include <quell/filter/filter_kernel.hpp>

namespace quell {

/// The longest sweep that may reach a pixel, in pixels; 0 where none does.
struct DominantSweep : MadeChannel<2> {
    static constexpr auto name = "dominant_sweep";
};
inline constexpr DominantSweep dominant_sweep;

namespace detail {
/// The longest of the sweeps here and a step away to either side. At borders the step is shorter: no window may have gaps there.
/// @tparam From the channel with the sweeps
template <ChannelTag From> struct LongestSweep {
    static constexpr auto name = "longest sweep";
    static constexpr bool leaves_signal = true;
    using reads = Channels<From>;
    using emits = Channels<DominantSweep>;
    int right, down; ///< the step, in pixels

    template <class Px> QUELL_KERNEL auto emit_channels(Px const& px) const {
        using Real = typename Px::Real;
        auto longest = Path<Real>::of(px[From{}], Real(0.5f));
        auto const take_longer = [&](float sign) QUELL_INLINED {
            auto const path = Path<Real>::of(px.elsewhere(place(px, sign), From{}), Real(0.5f));
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
        Real const last_column(static_cast<float>(px.size().width - 1)), last_row(static_cast<float>(px.size().height - 1));
        return PastPlace<Real>(clamp(p.x + (sign * static_cast<float>(right) - 0.5f), Real(0.f), last_column),
                               clamp(p.y + (sign * static_cast<float>(down) - 0.5f), Real(0.f), last_row));
    }
};

/// The paper's third pass: samples along the dominant sweep, weighed by what their own sweeps and depths say.
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
        // A thing's own colour counts the less, the more its sweep thins it out.
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
        return select(both(blurred, weights > Real(0.f)), scale(sum, 1.f / max(weights, Real(1e-6f))), own);
    }

private:
    static constexpr float shortest = 0.5f; ///< half of a sweep, in pixels: one less than that stays in its pixel

    /// Half of a sweep, from the middle of the shutter to its end, as far as a blur may reach.
    template <class Real> struct Half {
        vec2<Real> sweep;
        Real length;
    };
    template <class Real> QUELL_KERNEL Half<Real> half(vec2<Real> const& whole) const {
        auto const path = Path<Real>::of(whole, Real(0.5f));
        auto const length = path.length();
        auto const part = min(longest / max(length, Real(1e-6f)), Real(0.5f));
        return {scale(path.sweep, part), length * part};
    }
    /// What the weights want to know of a pixel: how far away it is, and how far it sweeps to either side.
    template <class Real> struct Seen { Real depth, radius; };
    template <class Real> QUELL_KERNEL Seen<Real> look(vec2<Real> const& whole, Real z) const {
        constexpr float nearest = 1e-6f, farthest = 1e30f;
        auto const known = select(is_finite(z), clamp(z, Real(nearest), Real(farthest)), Real(farthest));
        return {known, max(half(whole).length, Real(shortest))};
    }

    /// How much of the light from there is seen here: of something blurred before whatever is here; of what is behind something blurred
    /// here, as a guess at the background; and of both where they sweep over each other.
    template <class Real> QUELL_KERNEL Real weight(Seen<Real> const& here, Seen<Real> const& there, Real distance) const {
        auto const before = not_behind(there.depth, here.depth) * cone(distance, there.radius);
        auto const behind = not_behind(here.depth, there.depth) * cone(distance, here.radius);
        return before + behind + cylinder(distance, there.radius) * cylinder(distance, here.radius) * 2.f;
    }
    /// 1 where a is no farther than b, falling to 0 as it is.
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

/// Motion blur of a sharp picture that spreads beyond the outlines of what moves: every pixel looks along the longest sweep around, and
/// weighs what it finds by the samples' own sweeps and by whether they are before or behind it (McGuire et al. 2012, A Reconstruction
/// Filter for Plausible Motion Blur). A baseline: it knows nothing of what was hidden in the middle of the shutter.
/// "Around" is a window as far to each side as a blur may reach, where the paper has the 3x3 tiles around the pixel's own: within these
/// tiles, it has all that can matter to the pixel, and no tile's border shows.
/// Wants a signal as it is in the middle of the open shutter, and reads Sweep and Depth. Where nothing moves, the signal keeps every bit.
struct TileMaxBlur {
    using reads = Channels<Sweep, Depth>;
    using emits = Channels<DominantSweep>;
    int tile = 20;              ///< how far a blur may reach, in pixels; longer sweeps count as twice that; at least 1
    int samples = 15;           ///< along the dominant sweep, the pixel itself included; odd
    float depth_extent = 0.02f; ///< how much farther, relatively, something is that is behind for certain; the paper has a length for it

    constexpr void for_each_pass(auto&& pass) const {
        pass(detail::LongestSweep<Sweep>{1, 0});
        widen(1, [&](int step) { pass(detail::LongestSweep<DominantSweep>{step, 0}); });
        widen(0, [&](int step) { pass(detail::LongestSweep<DominantSweep>{0, step}); });
        pass(detail::TileMaxGather{samples, static_cast<float>(tile), depth_extent});
    }

private:
    /// Steps that widen a window which reaches so far already up to the tile's size. Each may be as long as the window is wide.
    constexpr void widen(int reached, auto&& by) const {
        for (int step = 0; reached < tile; reached += step) {
            int const width = 2 * reached + 1, rest = tile - reached;
            step = width < rest ? width : rest;
            by(step);
        }
    }
};

} // namespace quell
