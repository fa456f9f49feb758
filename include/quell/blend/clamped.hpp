#pragma once

#include <quell/blend/blend_policy.hpp>
#include <quell/frame/cursor/taps.hpp>
#include <quell/frame/hull.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

// Ranges that a history can be brought into. A range is a struct of numbers with a Gatherer for values V, which measures the neighbourhood:
//
//     explicit Gatherer(V const& centre)                   // a value to take differences from: it is not counted yet
//     void add(V const& v, Real weight, int dx, int dy)    // each pixel of the neighbourhood once, the centre (0, 0) among them
//     void finish(Range const& range)                      // after the last
//
// The weight is 0 for a missing sample and outside the image, and 1 else. A Gatherer then has
//
//     V low, high                                          // the past's components are clamped to them; or
//     V clip(V const& past) const                          // the past, moved into the range in another way

/// Range: minimum to maximum of the neighbourhood, per component.
struct MinMax {
    /// @cond
    template <class V> struct Gatherer {
        using Real = real_of<V>;
        V low, high;
        QUELL_KERNEL explicit Gatherer(V const& centre) : low(centre), high(centre) {}
        QUELL_KERNEL void add(V const& v, Real weight, int, int) {
            auto const counts = weight > Real(0.f);
            low = map([&](auto a, auto b) QUELL_INLINED { return select(counts, min(a, b), a); }, low, v);
            high = map([&](auto a, auto b) QUELL_INLINED { return select(counts, max(a, b), a); }, high, v);
        }
        QUELL_KERNEL void finish(MinMax) {}
    };
    /// @endcond
};

/// Range: mean +- `sigmas` standard deviations of the neighbourhood, per component (Salvi 2015).
struct MeanDeviation {
    float sigmas = 1.f; ///< above 0; 1 where motion may be wrong, 3 with reliable motion (TRMV section 5)

    /// @cond
    template <class V> struct Gatherer {
        using Real = real_of<V>;
        V low, high, centre;
        Real weight = Real(0.f);
        QUELL_KERNEL explicit Gatherer(V const& centre_) : low(zero<V>()), high(zero<V>()), centre(centre_) {}
        /// Sums differences from the centre: squares of HDR values would cancel.
        QUELL_KERNEL void add(V const& v, Real w, int, int) {
            auto const d = map([](auto a, auto b) QUELL_INLINED { return a - b; }, v, centre);
            low = map([&](auto s, auto a) QUELL_INLINED { return s + a * w; }, low, d);
            high = map([&](auto s, auto a) QUELL_INLINED { return s + a * a * w; }, high, d);
            weight = weight + w;
        }
        QUELL_KERNEL void finish(MeanDeviation p) {
            auto const inverse = 1.f / max(weight, Real(1.f));
            auto const mean = scale(low, inverse);
            auto const reach = map(
                [&](auto squares, auto m) QUELL_INLINED { return sqrt(max(squares * inverse - m * m, Real(0.f))) * p.sigmas; }, high, mean);
            auto const middle = map([](auto m, auto c) QUELL_INLINED { return m + c; }, mean, centre);
            low = map([](auto m, auto r) QUELL_INLINED { return m - r; }, middle, reach);
            high = map([](auto m, auto r) QUELL_INLINED { return m + r; }, middle, reach);
        }
    };
    /// @endcond
};

namespace detail {
template <class G, class V>
concept Clips = requires(G const& bounds, V const& past) {
    { bounds.clip(past) } -> std::same_as<V>;
};
template <class G>
concept HasBounds = requires(G const& bounds) {
    bounds.low, bounds.high;
};
/// Whether a range has a Gatherer as Clamped uses it, of the values of a colour.
template <class Range, class V = vec3<float>>
concept MeasuresRange = requires {
    typename Range::template Gatherer<V>;
}
&&requires(typename Range::template Gatherer<V> bounds, Range const& range, V const& value) {
    requires std::is_constructible_v<decltype(bounds), V const&>;
    bounds.add(value, 1.f, 0, 0);
    bounds.finish(range);
    requires Clips<decltype(bounds), V> || HasBounds<decltype(bounds)>;
};
template <class Axes, class V = vec3<float>>
concept IsAxes = requires(V const& v) {
    { Axes::to(Axes::from(v)) } -> std::same_as<V>;
};
/// The past moved into what a Gatherer has measured.
template <class G, class V> QUELL_KERNEL V clipped(G const& bounds, V const& past) {
    if constexpr (Clips<G, V>)
        return bounds.clip(past);
    else {
        static_assert(!NamesClip<G>,
                      "`clip` of a Gatherer must be a function V clip(V const& past) const; any other member needs another name");
        return map([](auto a, auto low, auto high) QUELL_INLINED { return clamp(a, low, high); }, past, bounds.low, bounds.high);
    }
}
} // namespace detail

// Colour spaces to clamp in.

/// Clamps each component as it is.
struct Rgb {
    /// From the signal to the space of the clamp.
    template <class V> QUELL_KERNEL static V from(V const& v) { return v; }
    /// Back to the signal.
    template <class V> QUELL_KERNEL static V to(V const& v) { return v; }
};

/// Clamps luma and two chromas: a tighter box, since neighbouring colours differ mostly in brightness. Signals that are not colours are
/// clamped as they are.
struct YCoCg {
    /// RGB to YCoCg.
    template <class V> QUELL_KERNEL static V from(V const& v) {
        if constexpr (components_of<V> != 3)
            return v;
        else
            return {v.x * 0.25f + v.y * 0.5f + v.z * 0.25f, (v.x - v.z) * 0.5f, v.y * 0.5f - (v.x + v.z) * 0.25f};
    }
    /// YCoCg to RGB.
    template <class V> QUELL_KERNEL static V to(V const& v) {
        if constexpr (components_of<V> != 3)
            return v;
        else
            return {v.x + v.y - v.z, v.x + v.z, v.x - v.y - v.z};
    }
};

/// Clamps the history to the range of the pixel's neighbourhood, then lets the inner policy blend. Adds the relative change to
/// HistorySample::clamped, which Adaptive and WithCleanUp read.
///
///     Clamped{RunningMean{}, MeanDeviation{.sigmas = 3}}
///
/// @tparam Inner  a BlendPolicy
/// @tparam Range  MinMax, MeanDeviation, or one of the host's, see above
/// @tparam Axes   Rgb or YCoCg
/// @tparam radius of the neighbourhood, in pixels: 1 is 3x3
template <class Inner, class Range = MeanDeviation, class Axes = Rgb, int radius = 1> struct Clamped {
    static_assert(BlendPolicy<Inner>, "Clamped{inner, range}: `inner` must have blend(px, past), see quell/blend/blend_policy.hpp");
    static_assert(std::is_trivially_copyable_v<Range>,
                  "Clamped{inner, range}: a policy must be trivially copyable, so that it can be sent to a device: plain numbers only");
    static_assert(detail::MeasuresRange<Range>, "Clamped{inner, range}: `range` must have a Gatherer with add(value, weight, dx, dy), "
                                                "finish(range), and `low` and `high` or clip(past), see quell/blend/clamped.hpp");
    static_assert(detail::IsAxes<Axes>, "Clamped{inner, range, axes}: `axes` must have from(value) and to(value), such as YCoCg{}");
    using parts = Parts<Inner>;
    static constexpr int farthest_tap = radius;

    Inner inner{}; ///< blends the clamped history
    Range range{}; ///< how wide the box is
    Axes axes{};   ///< the space in which it is a box

    /// The inner policy's: what a clamp has narrowed is hidden sooner.
    [[nodiscard]] constexpr BlendMemory memory() const { return memory_of(inner).hidden_after(4.f); }

    /// The inner policy's result for the clamped history. Missing neighbours do not count.
    QUELL_KERNEL auto blend(auto px, auto past) const {
        using V = typename decltype(px)::Signal;
        using Real = typename decltype(px)::Real;
        typename Range::template Gatherer<V> bounds(Axes::from(px.signal()));
        detail::Hull<V> seen(past.signal);
        for_each_neighbour<radius>(px, [&](auto neighbour, auto weight, int dx, int dy) QUELL_INLINED {
            auto const counted = select(neighbour.missing(), Real(0.f), weight);
            bounds.add(Axes::from(neighbour.signal()), counted, dx, dy);
            if constexpr (!std::is_same_v<Axes, Rgb>) seen.add(neighbour.signal(), counted > Real(0.f));
        });
        bounds.finish(range);
        auto inside = Axes::to(detail::clipped(bounds, Axes::from(past.signal)));
        // A corner of a box in other axes may be a colour that nothing around has.
        if constexpr (!std::is_same_v<Axes, Rgb>) inside = seen.limited(inside);
        past.clamped = past.clamped + relative_change(inside, past.signal);
        past.signal = inside;
        return inner.blend(px, past);
    }

private:
    /// Change of luminance over luminance before: w_C of TRMV eq. 8. At most about 1000, where there was no light.
    template <class V> QUELL_KERNEL static auto relative_change(V const& after, V const& before) {
        using Real = real_of<V>;
        auto const change = map([](auto a, auto b) QUELL_INLINED { return abs(a - b); }, after, before);
        auto const brightness = fma(abs(luminance(after)), Real(1e-3f), abs(luminance(before)));
        return luminance(change) / max(brightness, Real(1e-37f));
    }
};
template <class Inner> Clamped(Inner) -> Clamped<Inner>;
template <class Inner> Clamped(Inner, MeanDeviation) -> Clamped<Inner>;
template <class Inner, class Range> Clamped(Inner, Range) -> Clamped<Inner, Range>;
template <class Inner, class Range, class Axes> Clamped(Inner, Range, Axes) -> Clamped<Inner, Range, Axes>;

} // namespace quell::inline QUELL_INSTRUCTION_SET
