#pragma once

#include <quell/blend/blend_policy.hpp>
#include <quell/filter/filter_kernel.hpp>
#include <quell/motion/surface_motion.hpp>

namespace quell {

/// How far the luminance around a pixel lies from what the history shows there: the sum of the distances in n pixels, and the root of the
/// sum of their squares, both over sqrt(n), so that their quotient is Student's statistic and half precision holds them.
struct LightChange : MadeChannel<2> {
    static constexpr auto name = "light_change";
};
inline constexpr LightChange light_change;

namespace detail {
/// A sample beside its history, in which there is no interpolation: the luminance now less that of then, where both are known.
template <class P, class Real, class Mask> struct BesidePast {
    P past;
    Real distance;
    Mask known;
};
template <class P, class Real, class Mask> BesidePast(P, Real, Mask) -> BesidePast<P, Real, Mask>;
template <class Px> QUELL_KERNEL auto beside_past(Px const& px, auto const& source) {
    using Real = typename Px::Real;
    auto const past = Nearest{}.fetch(px, source.previous(px));
    auto const distance = luminance(px.signal()) - luminance(past.signal);
    return BesidePast{past, distance, both(past.validity > Real(0.f), invert(px.missing()), is_finite(distance))};
}

/// What a pixel by itself knows: nothing where there is no past or no sample.
template <class Source> struct OwnLightChange {
    static constexpr auto name = "light change";
    using parts = Parts<Source>;
    using emits = Channels<LightChange>;
    Source source;

    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        Real distance(0.f);
        if (px.has_past()) {
            auto const found = beside_past(px, source);
            distance = select(found.known, found.distance, distance);
        }
        return emitted<Real>(light_change, vec2<Real>{distance, abs(distance)});
    }
};

/// Puts together five in a row or a column.
struct LightChangeLine {
    static constexpr auto name = "light change";
    using reads = Channels<LightChange>;
    using emits = Channels<LightChange>;
    int step;
    bool vertical;

    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        Real sum(0.f), squares(0.f);
        for_each_of_five(px, step, vertical, [&](auto const& neighbour, auto inside) QUELL_INLINED {
            auto const change = neighbour[light_change];
            sum = sum + masked(inside, change.x);
            squares = squares + masked(inside, change.y * change.y);
        });
        return emitted<Real>(light_change, vec2<Real>{sum * 0.4472136f, sqrt(squares * 0.2f)});
    }
};
} // namespace detail

/// Notices light that has changed by itself, where motion is followed rightly and the history is wrong nevertheless: in many pixels
/// together the noise cancels that hides it in one. Goes before a Temporal{..., ForgetChanged{...}}.
///     Spatial{ChangeDetector<>{}}, Temporal{SurfaceMotion{}, ForgetChanged{RunningMean{}}}
/// @tparam Source a MotionSource
template <class Source = SurfaceMotion<SameDepth>> struct ChangeDetector {
    using Own = detail::OwnLightChange<Source>;
    using Line = detail::LightChangeLine;
    using parts = Parts<Own>;
    static constexpr bool leaves_signal = true;
    Source source{};
    int levels = 2; ///< 1: 5x5 pixels, 2: 25x25, which sees through more noise and less sharply

    constexpr void for_each_pass(auto&& pass) const {
        pass(Own{source});
        for (int i = 0, step = 1; i < levels; ++i, step *= 5) {
            pass(Line{step, false});
            pass(Line{step, true});
        }
    }
};

/// Trusts the past as little as ChangeDetector's evidence has it. The statistic, (sum of the distances)^2 / (sum of their squares), is 1 on
/// average where nothing has changed, however heavy the tails of the noise (one firefly by itself makes it 1), and grows with the number
/// of pixels where something has. Decorates a RunningMean or any policy that goes by the validity of the past.
template <class Inner> struct ForgetChanged {
    static_assert(BlendPolicy<Inner>, "ForgetChanged{inner}: `inner` must have blend(px, past), see quell/blend/blend_policy.hpp");
    using parts = Parts<Inner>;
    using reads = Channels<LightChange>;
    Inner inner{};
    float by_chance = 16.f;  ///< what the statistic reaches where nothing has changed
    float sharpness = 400.f; ///< validity is divided by 1 + sharpness * (statistic - by_chance); one that beats a long history is larger

    QUELL_KERNEL auto blend(auto px, auto past) const {
        using Real = typename decltype(px)::Real;
        auto const change = px[light_change];
        auto const ratio = change.x / max(change.y, Real(1e-12f));
        auto const excess = max(ratio * ratio - by_chance, Real(0.f));
        past.validity = past.validity / fma(excess, Real(sharpness), Real(1.f));
        return inner.blend(px, past);
    }
};
template <class Inner> ForgetChanged(Inner) -> ForgetChanged<Inner>;

} // namespace quell
