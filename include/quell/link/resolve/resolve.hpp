#pragma once

#include <quell/blend/clamped.hpp>
#include <quell/core/real.hpp>
#include <quell/link/resolve/resolve_pixel.hpp>
#include <quell/link/resolve/sharpening.hpp>
#include <quell/link/seen_channels.hpp>
#include <quell/pipeline/chain.hpp>

#include <concepts>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// How much a sample tells about an output pixel: a Gaussian of the distance between the two. Kernels of a Resolve have weight(d2).
struct GaussianKernel {
    float deviation = 0.45f; ///< in output pixels, > 0

    /// 1 at the pixel's centre. The namespace is named, since xsimd has an exp for packs with other bits.
    /// @param squared_distance in output pixels
    template <class Real> QUELL_KERNEL Real weight(Real squared_distance) const {
        return quell::exp(squared_distance * (-0.5f / (deviation * deviation)));
    }
};

namespace detail {
template <class K>
concept WeighsDistance = requires(K const& kernel) {
    { kernel.weight(1.f) } -> std::same_as<float>;
};
/// What a Resolve clamps to unless it is told otherwise. Samples of other places differ more than noise does.
template <class Range> inline constexpr Range range_of_resolve{};
template <> inline constexpr MeanDeviation range_of_resolve<MeanDeviation>{.sigmas = 1.5f};

/// Ranges around each pixel of this frame.
struct RangeLow : InternalChannel<3> {
    static constexpr auto name = "range_low";
};
struct RangeHigh : InternalChannel<3> {
    static constexpr auto name = "range_high";
};
struct RangeOfDepths : ExactChannel<2> {
    static constexpr auto name = "range_of_depths";
};

/// Keeps the frame, and finds the ranges around each pixel.
template <class Policies> struct PrepareResolve {
    static constexpr auto name = "prepare resolve";
    using reads = Channels<Depth, Motion>;
    using emits = Channels<RangeLow, RangeHigh, RangeOfDepths>;
    using keeps = Channels<SeenPicture, SeenVector, SeenDepth>;
    static constexpr int farthest_tap = 1;
    Policies policies;

    template <class Px> struct Seen {
        using Real = typename Px::Real;
        Px px;
        QUELL_KERNEL Seen at(int dx, int dy) const { return {px.at(dx, dy)}; }
        QUELL_KERNEL auto inside() const { return px.inside(); }
        [[nodiscard]] QUELL_KERNEL bool any_row_inside() const { return px.any_row_inside(); }
        QUELL_KERNEL vec3<Real> picture() const { return px.signal(); }
        QUELL_KERNEL Real depth() const { return px[quell::depth]; }
        QUELL_KERNEL vec2<Real> motion() const { return px[quell::motion]; }
    };
    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const around = ranges_around<vec3<Real>>(policies, Seen<decltype(px)>{px});
        vec2<Real> vector{Real(1e9f), Real(1e9f)};
        if (px.has_past()) {
            auto const now = px.jitter_now(), then = px.jitter_then();
            vector = {around.vector.x + (now.x - then.x), around.vector.y + (now.y - then.y)};
        }
        return emitted<Real>(RangeLow{}, around.low)
            .with(RangeHigh{}, around.high)
            .with(RangeOfDepths{}, around.depths)
            .with(SeenPicture{}, px.signal())
            .with(SeenVector{}, vector)
            .with(SeenDepth{}, px[depth]);
    }
};

/// A channel of the last frame, or of one farther back.
template <ChannelTag C, int frames> using OfPast = std::conditional_t<frames == 0, C, Earlier<C, frames + (frames == 0)>>;
template <int... k>
auto kept_by_resolve(std::integer_sequence<int, k...>)
    -> union_of<Channels<OfPast<SeenPicture, k>, OfPast<SeenVector, k>, OfPast<SeenDepth, k>>...>;

/// Puts the picture together from this frame and those before it.
template <class Policies, int frames> struct TakeResolved {
    static constexpr auto name = "resolve";
    using reads = Channels<RangeLow, RangeHigh, RangeOfDepths, SeenVector>;
    using reads_kept = decltype(kept_by_resolve(std::make_integer_sequence<int, frames>{}));
    static constexpr int farthest_tap = anywhere;
    Policies policies;

    /// A frame whose places are those of its samples.
    template <class Px> struct Raster {
        using Real = typename Px::Real;
        Px const& px;
        QUELL_KERNEL auto size() const { return px.size(); }
        QUELL_KERNEL vec2<Real> where(vec2<Real> const& place) const { return place; }
        QUELL_KERNEL vec2<Real> moved(vec2<Real> const& place, vec2<Real> const& vector) const { return place + vector; }
        QUELL_KERNEL vec2<Real> off_centre(vec2<Real> const& at) const { return {at.x - floor(at.x) - 0.5f, at.y - floor(at.y) - 0.5f}; }
    };
    template <class Px> struct Now : Raster<Px> {
        using Real = typename Px::Real;
        QUELL_KERNEL vec3<Real> picture(auto const& place, int dx, int dy) const { return this->px.signal_elsewhere(place, dx, dy).first; }
        QUELL_KERNEL vec2<Real> vector(auto const& place) const { return this->px.elsewhere(place, SeenVector{}); }
    };
    template <class Px, int k> struct Then : Raster<Px> {
        using Real = typename Px::Real;
        QUELL_KERNEL vec3<Real> picture(auto const& place, int dx, int dy) const {
            return this->px.past(place, dx, dy)[OfPast<SeenPicture, k>{}];
        }
        QUELL_KERNEL Real depth(auto const& place) const { return this->px.past(place)[OfPast<SeenDepth, k>{}]; }
        QUELL_KERNEL vec2<Real> vector(auto const& place) const { return this->px.past(place)[OfPast<SeenVector, k>{}]; }
    };
    template <class Px> struct Seen {
        using Real = typename Px::Real;
        Px const& px;
        QUELL_KERNEL Now<Px> now() const { return {{px}}; }
        QUELL_KERNEL vec2<Real> place() const {
            auto const jitter = px.jitter_now();
            auto const at = px.position();
            return {at.x - jitter.x, at.y - jitter.y};
        }
        QUELL_KERNEL auto contains(vec2<Real> const& place) const {
            auto const size = px.size();
            return both(place.x >= Real(0.f), place.x < Real(to_real(size.width)), place.y >= Real(0.f),
                        place.y < Real(to_real(size.height)));
        }
        QUELL_KERNEL RangesAround<vec3<Real>> around(auto const& place) const {
            return {px.elsewhere(place, RangeLow{}), px.elsewhere(place, RangeHigh{}), px.elsewhere(place, RangeOfDepths{}), {}};
        }
        QUELL_KERNEL void each_past(auto&& visit) const {
            if (!px.has_past()) return;
            bool goes_on = true;
            // All frames have the same raster.
            [&]<int... k>(std::integer_sequence<int, k...>) QUELL_INLINED {
                ((goes_on = goes_on && visit(Then<Px, k>{{px}}, Raster<Px>{px})), ...);
            }
            (std::make_integer_sequence<int, frames>{});
        }
    };
    QUELL_KERNEL auto filter(auto px) const { return resolved<typename decltype(px)::Signal>(policies, Seen<decltype(px)>{px}); }
};
} // namespace detail

/// Temporal anti-aliasing and upsampling. Samples of the last frames are moved along their motion to where they are now. Each output pixel
/// takes a mean of them, in which a sample weighs by how near it lies to the pixel's centre. With jitter, or with any motion, samples of
/// many places meet at each pixel: edges become smooth, and an output that is larger than the input becomes sharp.
///
/// Usual temporal anti-aliasing (Yang, Liu and Salvi 2020, "A Survey of Temporal Antialiasing Techniques") keeps one picture and moves it
/// from frame to frame, which blurs it a little each time. Here the frames themselves are kept, at the input's size. As there, the past is
/// sought along the motion of the nearest surface in the 3x3 around, so that edges move with what they belong to, and clamped to the range
/// of the 3x3 around. A sample whose depth is none of those around counts nothing.
///
/// presets::resolve() puts it behind a denoiser, for an output of any size. As a filter of a link, `Pipeline{denoised,
/// Spatial{Resolve{}}}`, it is for frames of the output's size.
/// @tparam Kernel     how a sample's distance weighs: GaussianKernel, or another one with weight(squared distance)
/// @tparam Range      MinMax, MeanDeviation, or another one with `low` and `high` (blend/clamped.hpp)
/// @tparam Axes       the colour space in which the past is clamped: YCoCg or Rgb
/// @tparam Sharpening what happens to the output: NoSharpening or Sharpen
/// @tparam frames     how many frames of the past are kept, 1 to 15; by a link 1 to 10
template <class Kernel = GaussianKernel, class Range = MeanDeviation, class Axes = YCoCg, class Sharpening = NoSharpening, int frames = 6>
struct Resolve {
    static_assert(detail::WeighsDistance<Kernel>,
                  "Resolve{kernel, range, axes, sharpening}: `kernel` must have weight(squared distance), such as GaussianKernel{}");
    static_assert(detail::MeasuresRange<Range>, "Resolve{kernel, range, axes, sharpening}: `range` must have a Gatherer with add(value, "
                                                "weight, dx, dy), finish(range), `low` and `high`, see quell/blend/clamped.hpp");
    static_assert(detail::IsAxes<Axes>,
                  "Resolve{kernel, range, axes, sharpening}: `axes` must have from(value) and to(value), such as YCoCg{}");
    static_assert(frames >= 1 && frames <= 15, "Resolve<..., frames>: it keeps 1 to 15 frames");
    static constexpr int past_frames = frames; ///< that are kept

    Kernel kernel{};                               ///< how a sample's distance weighs
    Range range = detail::range_of_resolve<Range>; ///< what the past is clamped to
    Axes axes{};                                   ///< where that is a box
    Sharpening sharpening{};                       ///< of the output
    float depth_tolerance = 0.03f;                 ///< how far a past sample's depth may lie outside those around, as a part of them

    /// @cond
    static constexpr bool checks_jitter = true;
    static constexpr bool sharpens = !std::is_same_v<Sharpening, NoSharpening>;
    using parts = std::conditional_t<sharpens, Parts<detail::PrepareResolve<Resolve>, detail::TakeResolved<Resolve, frames>, Sharpening>,
                                     Parts<detail::PrepareResolve<Resolve>, detail::TakeResolved<Resolve, frames>>>;
    constexpr void for_each_pass(auto&& pass) const {
        pass(detail::PrepareResolve<Resolve>{*this}), pass(detail::TakeResolved<Resolve, frames>{*this});
        if constexpr (sharpens) pass(sharpening);
    }
    /// @endcond
};
/// @cond
Resolve()->Resolve<>;
template <class Kernel> Resolve(Kernel) -> Resolve<Kernel>;
template <class Kernel, class Range> Resolve(Kernel, Range) -> Resolve<Kernel, Range>;
template <class Kernel, class Range, class Axes> Resolve(Kernel, Range, Axes) -> Resolve<Kernel, Range, Axes>;
template <class Kernel, class Range, class Axes, class Sharpening>
Resolve(Kernel, Range, Axes, Sharpening) -> Resolve<Kernel, Range, Axes, Sharpening>;
/// @endcond

} // namespace quell::inline QUELL_INSTRUCTION_SET
