#pragma once

#include "revisit.hpp"
#include "trace.hpp"

namespace quell::tracer {

namespace detail {

template <class C> struct GradientSignal { using type = Channels<>; };
template <ChannelTag Signal> struct GradientSignal<GradientOf<Signal>> { using type = Channels<Signal>; };

template <class Set> struct GradientSignals;
template <class... Cs> struct GradientSignals<Channels<Cs...>> { using type = union_of<typename GradientSignal<Cs>::type...>; };

} // namespace detail

/// The signals whose temporal gradients are in a set.
template <class Wanted> using gradient_signals = typename detail::GradientSignals<Wanted>::type;
template <class Wanted> inline constexpr bool wants_gradients = gradient_signals<Wanted>::size > 0;

/// One surface point in two frames: the scene with its camera, standing at this frame, and another standing at the frame before.
struct TwoFrames {
    PreparedScene const &now, &before;
    View const &view, &view_before;
    Extent size;
};

/// What gradients are of.
template <class Signal> float luminance_of(Signal, Surface const& surface, Signals const& signals) {
    if constexpr (std::is_same_v<Signal, Visibility>) return signals.visibility;
    if constexpr (std::is_same_v<Signal, Glossy>) return luminance(signals.glossy);
    if constexpr (std::is_same_v<Signal, Indirect>) return luminance(signals.indirect);
    if constexpr (std::is_same_v<Signal, Radiance>) return luminance(composite(surface.diffuse(), signals));
}

/// Shades the point that was hit with the same random numbers in both frames, and hands take() the surface and the signals now, and those
/// before. False, and nothing shaded, where the point was not seen before. Such points that were not seen before are left out: there is
/// nothing that their history could be compared with, and as they add nothing to either of the sums that A-SVGF divides by each other,
/// their neighbours' gradients speak for them.
template <class Wanted> bool shade_twice(TwoFrames const& frames, Hit const& hit, PathContext const& path, auto&& take) {
    auto const before = revisit(frames.before, frames.view_before, hit, path.time);
    ++path.counts->primary;
    if (!is_seen(frames.before, frames.view_before, frames.size, before)) return false;
    auto const shaded = [&](PreparedScene const& scene, Revisited const& point) {
        return trace_signals<gradient_signals<Wanted>>(scene, point.surface, -point.ray.direction, path, frames.view.pixel_angle());
    };
    auto const now = revisit(frames.now, frames.view, hit, path.time);
    take(now.surface, shaded(frames.now, now), before.surface, shaded(frames.before, before));
    return true;
}

} // namespace quell::tracer
