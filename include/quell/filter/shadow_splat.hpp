#pragma once

#include <quell/filter/edge_weights.hpp>
#include <quell/motion/catmull_rom.hpp>
#include <quell/motion/shadow_motion.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Motion and penumbra of the shadow around a pixel. x, y: motion to the previous frame, in pixels. z: width of the penumbra, in pixels. w:
/// total weight of the pixels that know; 0: no shadow near. x, y and z are means with these weights.
struct ShadowTrack : InternalChannel<4> {
    /// @cond
    static constexpr auto name = "shadow_track";
    static constexpr bool full_precision = true; // as Motion
    /// @endcond
};
inline constexpr ShadowTrack shadow_track;

namespace detail {
/// The track of pixels whose own shadow ray was blocked.
template <class Source> struct OwnShadowTrack {
    static constexpr auto name = "shadow motion";
    using parts = Parts<Source>;
    using reads = Channels<Position, Depth, Light, Blocker>;
    static constexpr bool needs_camera = true;
    using emits = Channels<ShadowTrack>;
    static constexpr int farthest_tap = 1;
    Source source;
    float light_size;

    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const found = source.previous(px);
        auto const p = px.position();
        auto const valid = both(found.validity > Real(0.f), is_finite(found.where.x), is_finite(found.where.y));
        auto const width = penumbra(px);
        auto const known = masked(both(valid, is_finite(width)), Real(1.f));
        auto const lit = invert(valid);
        return emitted<Real>(shadow_track,
                             Value<4, Real>{select(lit, Real(0.f), found.where.x - p.x), select(lit, Real(0.f), found.where.y - p.y),
                                            select(lit, Real(0.f), width), known});
    }

private:
    /// (d_receiver - d_blocker) * light size / d_blocker, with distances from the light; in pixels at the receiver.
    template <class Px> QUELL_KERNEL auto penumbra(Px const& px) const {
        using Real = typename Px::Real;
        auto const l = px[light], s = px[position], b = px[blocker];
        auto const to_receiver = length(s - l), to_blocker = length(b - l);
        auto const size = light_size > 0.f ? Real(light_size) : spread(px, l);
        auto const world = max(to_receiver - to_blocker, Real(0.f)) * size / max(to_blocker, Real(1e-6f));
        return world / max(px[depth] * px.rays().pixel_size, Real(1e-12f));
    }
    /// Side of a square light, estimated from the light samples of the 3x3 around.
    template <class Px, class V> QUELL_KERNEL static auto spread(Px const& px, V const& centre) {
        using Real = typename Px::Real;
        Real sum(0.f), count(1e-6f);
        for_each_neighbour<1>(px, [&](auto neighbour, auto inside, int, int) QUELL_INLINED {
            auto const off = neighbour[light] - centre;
            auto const square = dot(off, off);
            auto const w = masked(is_finite(square), inside);
            sum = fma(masked(is_finite(square), square), w, sum);
            count = count + w;
        });
        // Two random points of a square are sqrt(side^2 / 3) apart (root mean square). The centre is one of the nine.
        return sqrt(sum / count * (3.f * 9.f / 8.f));
    }
};

/// Mean of the tracks around, stopped by edges.
template <class Edge> struct SplatLevel {
    static constexpr auto name = "shadow splat";
    using parts = Parts<Edge>;
    using reads = Channels<ShadowTrack>;
    using emits = Channels<ShadowTrack>;
    Edge edge;
    int step;

    constexpr int farthest_tap() const { return 2 * step; }

    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const around = edge.around(px);
        auto const own = px[shadow_track];
        Value<4, Real> sum{own.x * own.w, own.y * own.w, own.z * own.w, own.w};
        // Small weights: a pixel that knows its own motion keeps it. The mean of a moving and a resting shadow is neither.
        constexpr float of_neighbours = 0.01f;
        for_each_edge_tap<false, 2>(px, step, around, [&](auto const& tap) QUELL_INLINED {
            auto const track = tap.px[shadow_track];
            auto const weight = track.w * tap.weight(WeightBits::of(of_neighbours));
            sum = Value<4, Real>{fma(track.x, weight, sum.x), fma(track.y, weight, sum.y), fma(track.z, weight, sum.z), sum.w + weight};
        });
        auto const known = sum.w > Real(1e-5f);
        auto const inverse = 1.f / select(known, sum.w, Real(1.f));
        return emitted<Real>(shadow_track, Value<4, Real>{sum.x * inverse, sum.y * inverse, sum.z * inverse, masked(known, sum.w)});
    }
};
} // namespace detail

/// Makes ShadowTrack for all pixels in or near a shadow (splatting, TRMV section 4.1). Only pixels whose shadow ray was blocked know the
/// shadow's motion themselves; two 5x5 means, with taps 1 and 5 pixels apart, spread it 12 pixels far. Goes before what reads the track:
/// AdaptiveBilateral with PenumbraWidth, and SplattedShadowMotion.
/// @tparam Source a MotionSource that is valid in shadowed pixels only
/// @tparam Edge   an EdgeWeight that keeps surfaces apart
template <class Source = ShadowMotion, class Edge = DepthEdge> struct ShadowSplat {
    static_assert(EdgeWeight<Edge>, "ShadowSplat{source, edge}: `edge` must have around(px), see quell/filter/filter_kernel.hpp");
    /// @cond
    using parts = Parts<detail::OwnShadowTrack<Source>, detail::SplatLevel<Edge>>;
    static constexpr bool leaves_signal = true;
    /// @endcond
    Source source{};        ///< the shadow's motion where the ray was blocked
    Edge edge{};            ///< how far tracks spread
    float light_size = 0.f; ///< side of the lights, in world units; 0: estimated from neighbouring pixels' light samples

    /// Own tracks, then the two means.
    constexpr void for_each_pass(auto&& pass) const {
        pass(detail::OwnShadowTrack<Source>{source, light_size});
        pass(detail::SplatLevel<Edge>{edge, 1});
        pass(detail::SplatLevel<Edge>{edge, 5});
    }
};

/// Width of an AdaptiveBilateral on shadows: clamp(part * penumbra, low, max_width), where low = min(min_width, min_width_part * penumbra).
/// The second term of `low` keeps narrow penumbrae sharp: they have little noise, and thin shadows may be no wider themselves. The minimum
/// is 0.1 pixels, which filters nothing; it holds where no shadow is near.
struct PenumbraWidth {
    using reads = Channels<ShadowTrack>;
    static constexpr int farthest_tap = 0;
    float part = 0.15f;           ///< standard deviation of the Gaussian, as a part of the penumbra
    float min_width = 0.5f;       ///< in pixels; wide enough to reach the next pixels
    float max_width = 7.5f;       ///< in pixels
    float min_width_part = 0.25f; ///< bounds `min_width` to this part of the penumbra

    /// Standard deviation at the pixel, in pixels.
    QUELL_KERNEL auto of(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const penumbra = px[shadow_track].z;
        // At 0.1 all weights but the centre's are 0 already.
        auto const low = max(min(Real(min_width), penumbra * min_width_part), Real(0.1f));
        return clamp(penumbra * part, low, Real(max_width));
    }
};

/// A MotionSource: the motion of ShadowTrack. Invalid where no shadow is near.
struct SplattedShadowMotion {
    using reads = Channels<ShadowTrack>;
    static constexpr bool needs_camera = true;
    static constexpr int farthest_tap = 0;

    /// See MotionSource.
    QUELL_KERNEL auto previous(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const track = px[shadow_track];
        auto const p = px.position();
        return Reprojection<Real>{{p.x + track.x, p.y + track.y}, masked(track.w > Real(0.f), Real(1.f))};
    }
};

/// A history fetch for shadows: CatmullRom along shadows, whose edges bilinear interpolation would blur over time, and Bilinear along
/// surfaces. It takes a source without a surface test for a shadow's.
struct ShadowFetch {
    static constexpr int farthest_tap = 0;
    CatmullRom along_shadows{}; ///< its `elsewhere` serves surfaces

    /// See quell/motion/history_fetch.hpp.
    template <class Px, class FoundPlace> QUELL_KERNEL auto fetch(Px const& px, FoundPlace const& found) const {
        if constexpr (std::is_same_v<FoundPlace, Reprojection<typename Px::Real>>)
            return along_shadows.fetch(px, found);
        else
            return along_shadows.elsewhere.fetch(px, found);
    }
};

/// A MotionSource: the motion of ShadowTrack where there is one, else that of the surface, without a surface test. For a ChangeDetector.
struct ShadowOrSurfaceMotion {
    using reads = Channels<ShadowTrack, Motion>;
    static constexpr int farthest_tap = 0;

    /// See MotionSource.
    QUELL_KERNEL auto previous(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const track = px[shadow_track];
        auto const surface = px[motion], p = px.position();
        auto const known = track.w > Real(0.f);
        return Reprojection<Real>{{p.x + select(known, track.x, surface.x), p.y + select(known, track.y, surface.y)}, Real(1.f)};
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
