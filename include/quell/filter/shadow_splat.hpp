#pragma once

#include <quell/filter/edge_weights.hpp>
#include <quell/motion/catmull_rom.hpp>
#include <quell/motion/shadow_motion.hpp>

namespace quell {

/// The shadow around a pixel: where it moves to in the previous frame (from this pixel, in pixels), how wide its penumbra is (pixels), and
/// how much of the neighbourhood knows. Each of the first three is a mean weighted by the last.
struct ShadowTrack : MadeChannel<4> {
    static constexpr auto name = "shadow_track";
    static constexpr bool full_precision = true; // as Motion
};
inline constexpr ShadowTrack shadow_track;

namespace detail {
/// What a shadowed pixel by itself knows of its shadow.
template <class Source> struct OwnShadowTrack {
    static constexpr auto name = "shadow motion";
    using parts = Parts<Source>;
    using reads = Channels<Position, Depth, Light, Blocker>;
    static constexpr bool needs_camera = true;
    using emits = Channels<ShadowTrack>;
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
    /// From similar triangles: (d_receiver - d_blocker) * light size / d_blocker, seen from the light, in pixels at the receiver.
    template <class Px> QUELL_KERNEL auto penumbra(Px const& px) const {
        using Real = typename Px::Real;
        auto const l = px[light], s = px[position], b = px[blocker];
        auto const to_receiver = length(s - l), to_blocker = length(b - l);
        auto const size = light_size > 0.f ? Real(light_size) : spread(px, l);
        auto const world = max(to_receiver - to_blocker, Real(0.f)) * size / max(to_blocker, Real(1e-6f));
        return world / max(px[depth] * px.rays().pixel_size, Real(1e-12f));
    }
    /// The side of a square light whose points lie as far from each other as those that the 3x3 around has drawn.
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
        // Two points of a square are sqrt(side^2 / 3) apart, in the mean of squares; the centre itself is one of the nine.
        return sqrt(sum / count * (3.f * 9.f / 8.f));
    }
};

/// Spreads what is known to the pixels around, as far as edges let it.
template <class Edge> struct SplatLevel {
    static constexpr auto name = "shadow splat";
    using parts = Parts<Edge>;
    using reads = Channels<ShadowTrack>;
    using emits = Channels<ShadowTrack>;
    Edge edge;
    int step;

    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const around = edge.around(px);
        auto const own = px[shadow_track];
        Value<4, Real> sum{own.x * own.w, own.y * own.w, own.z * own.w, own.w};
        auto const add = [&](auto const& neighbour, auto w) QUELL_INLINED {
            auto const track = neighbour[shadow_track];
            auto const weight = track.w * w;
            sum = Value<4, Real>{fma(track.x, weight, sum.x), fma(track.y, weight, sum.y), fma(track.z, weight, sum.z), sum.w + weight};
        };
        // Neighbours are little beside what a pixel knows itself: the mean of a moving and a resting shadow is neither.
        for_each_edge_tap<false>(
            px, step, around, [](int, int) QUELL_INLINED { return weight_bits(0.01f); }, add);
        auto const known = sum.w > Real(1e-5f);
        auto const inverse = 1.f / select(known, sum.w, Real(1.f));
        return emitted<Real>(shadow_track, Value<4, Real>{sum.x * inverse, sum.y * inverse, sum.z * inverse, masked(known, sum.w)});
    }
};
} // namespace detail

/// Lets every pixel in or near a shadow know how the shadow moves and how wide its penumbra is (TRMV section 4.1, which calls this
/// splatting): only pixels whose own shadow ray was blocked know by themselves. Two sparse 5x5 means reach 12 pixels. Goes before whatever
/// uses ShadowTrack: AdaptiveBilateral with PenumbraWidth, and SplattedShadowMotion.
/// @tparam Source a MotionSource that is valid in shadowed pixels only
/// @tparam Edge   an EdgeWeight that keeps surfaces apart
template <class Source = ShadowMotion, class Edge = DepthEdge> struct ShadowSplat {
    static_assert(EdgeWeight<Edge>, "ShadowSplat{source, edge}: `edge` must have around(px), see quell/filter/filter_kernel.hpp");
    using parts = Parts<detail::OwnShadowTrack<Source>, detail::SplatLevel<Edge>>;
    static constexpr bool leaves_signal = true;
    Source source{};
    Edge edge{};
    float light_size = 0.f; ///< side of the lights, in world units; 0: estimated from the light samples of neighbouring pixels

    constexpr void for_each_pass(auto&& pass) const {
        pass(detail::OwnShadowTrack<Source>{source, light_size});
        pass(detail::SplatLevel<Edge>{edge, 1});
        pass(detail::SplatLevel<Edge>{edge, 5});
    }
};

/// The width of an AdaptiveBilateral that filters shadows: a part of the penumbra's width, but no less than reaches the next pixels; a
/// shadow whose penumbra is as narrow as they are has hardly any noise, and may itself be no wider, so that there it is a part of the
/// penumbra again. Where no shadow is near, as narrow as it gets.
struct PenumbraWidth {
    using reads = Channels<ShadowTrack>;
    float part = 0.15f;          ///< deviation of the Gaussian, as a part of the penumbra
    float least = 0.5f;          ///< pixels
    float most = 7.5f;           ///< pixels
    float part_of_least = 0.25f; ///< of the penumbra, where `least` is more than this part

    QUELL_KERNEL auto of(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const penumbra = px[shadow_track].z;
        // Narrower than 0.1 all weights are 0 already.
        auto const low = max(min(Real(least), penumbra * part_of_least), Real(0.1f));
        return clamp(penumbra * part, low, Real(most));
    }
};

/// Follows the shadow that ShadowSplat has found around the pixel; invalid where there is none.
struct SplattedShadowMotion {
    using reads = Channels<ShadowTrack>;
    static constexpr bool needs_camera = true;

    QUELL_KERNEL auto previous(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const track = px[shadow_track];
        auto const p = px.position();
        return Reprojection<Real>{{p.x + track.x, p.y + track.y}, masked(track.w > Real(0.f), Real(1.f))};
    }
};

/// CatmullRom along shadows, whose edges a history blurs; Bilinear along surfaces, where they are lit: for the sources that take what they
/// find untested, and for all others.
struct ShadowFetch {
    CatmullRom along_shadows{};

    template <class Px, class FoundPlace> QUELL_KERNEL auto fetch(Px const& px, FoundPlace const& found) const {
        if constexpr (std::is_same_v<FoundPlace, Reprojection<typename Px::Real>>)
            return along_shadows.fetch(px, found);
        else
            return along_shadows.elsewhere.fetch(px, found);
    }
};

/// Follows the shadow where ShadowSplat has found one, and what is seen elsewhere; untested. For a ChangeDetector, whose answer is one
/// for both.
struct ShadowOrSurfaceMotion {
    using reads = Channels<ShadowTrack, Motion>;

    QUELL_KERNEL auto previous(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const track = px[shadow_track];
        auto const surface = px[motion], p = px.position();
        auto const known = track.w > Real(0.f);
        return Reprojection<Real>{{p.x + select(known, track.x, surface.x), p.y + select(known, track.y, surface.y)}, Real(1.f)};
    }
};

} // namespace quell
