#pragma once

#include <quell/core/real.hpp>
#include <quell/link/resolve/spline_interpolation.hpp>

/// The steps of a Resolve for one pixel, or a pack.
namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// What the 3x3 around a pixel of a frame has.
template <class V> struct RangesAround {
    using Real = real_of<V>;
    V low, high;       ///< of the colours, in the axes of the clamp
    vec2<Real> depths; ///< the nearest, and the farthest
    vec2<Real> vector; ///< the motion of the nearest
};
/// @param seen has at(dx, dy), of which each has inside(), any_row_inside(), picture(), depth() and motion()
template <class V> QUELL_KERNEL RangesAround<V> ranges_around(auto const& policies, auto const& seen) {
    using Real = real_of<V>;
    using Axes = std::remove_cvref_t<decltype(policies.axes)>;
    auto const here = seen.at(0, 0);
    typename std::remove_cvref_t<decltype(policies.range)>::template Gatherer<V> range(Axes::from(here.picture()));
    Real nearest = here.depth(), farthest = nearest;
    vec2<Real> vector = here.motion();
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
            auto const tap = seen.at(dx, dy);
            if (!tap.any_row_inside()) continue;
            auto const inside = tap.inside();
            range.add(Axes::from(tap.picture()), masked(inside, Real(1.f)), dx, dy);
            Real const depth = tap.depth();
            auto const nearer = both(inside, depth < nearest);
            if (any(nearer)) vector = select(nearer, tap.motion(), vector);
            nearest = select(nearer, depth, nearest), farthest = select(inside, max(farthest, depth), farthest);
        }
    range.finish(policies.range);
    return {range.low, range.high, {nearest, farthest}, vector};
}

/// An output pixel of a Resolve.
/// @param seen has place(), which goes from frame to frame, and contains(place); around(place of a pixel): RangesAround; now(), and
/// each_past(visit) for the frames before, the last first, until visit(frame, the frame behind it) is false. A frame has size(),
/// where(place) among its samples, where that of pixel (x, y) is at (x + .5, y + .5), moved(place, vector), off_centre(where) in pixels of
/// the output, and at the places of pixels picture(place, dx, dy), depth(place) and vector(place)
template <class V> QUELL_KERNEL V resolved(auto const& policies, auto const& seen) {
    using Real = real_of<V>;
    using Axes = std::remove_cvref_t<decltype(policies.axes)>;
    auto const weight_at = [&](auto const& frame, vec2<Real> const& where) QUELL_INLINED {
        auto const off = frame.off_centre(where);
        return policies.kernel.weight(off.x * off.x + off.y * off.y);
    };
    auto const now = seen.now();
    vec2<Real> place = seen.place();
    vec2<Real> where = now.where(place);
    V const own = interpolate(now, where);
    Real best = weight_at(now, where), total = best;
    V sum = scale(own, total);
    auto const here = nearest_place(now, where);
    auto const around = seen.around(here);
    Real const nearest = around.depths.x * (1.f - policies.depth_tolerance), farthest = around.depths.y * (1.f + policies.depth_tolerance);
    vec2<Real> vector = now.vector(here);
    auto known = Real(0.f) == Real(0.f);
    seen.each_past([&](auto const& then, auto const& behind) QUELL_INLINED {
        auto const moved = behind.moved(place, vector);
        known = both(known, all_finite(moved), seen.contains(moved));
        if (!any(known)) return false;
        place = select(known, moved, place);
        where = then.where(place);
        auto const there = nearest_place(then, where);
        Real const depth = then.depth(there);
        Real const weight = masked(both(known, depth >= nearest, depth <= farthest), weight_at(then, where));
        auto const colour = Axes::from(then.picture(there, 0, 0));
        auto const clamped = map([](auto a, auto l, auto h) QUELL_INLINED { return clamp(a, l, h); }, colour, around.low, around.high);
        sum = add_scaled(sum, V(Axes::to(clamped)), weight);
        total = total + weight;
        best = max(best, weight);
        vector = then.vector(there);
        return true;
    });
    // Where no sample of any frame lies near, the spline of this frame knows as much.
    V const mean = scale(sum, 1.f / max(total, Real(1e-12f)));
    return map([&](auto a, auto b) QUELL_INLINED { return fma(b - a, best, a); }, own, mean);
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
