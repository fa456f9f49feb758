#pragma once

#include <quell/frame/cursor/taps.hpp>
#include <quell/frame/hull.hpp>
#include <quell/motion/history_fetch.hpp>
#include <quell/motion/surface_test.hpp>
#include <quell/radiance/cones.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// A history fetch for WithCones: history from a surface with another normal moves to this pixel's cones, by their overlap.
///
///     Temporal{FirstValid{SurfaceMotion{}, DualMotion{}}, WithCones{RunningMean{}}, ConeFetch{}}
struct ConeFetch {
    using reads = Channels<Normal>;
    using remembers = Channels<Normal>;
    static constexpr int farthest_tap = 1;
    Bilinear inner{}; ///< interpolates the history

    /// See quell/motion/history_fetch.hpp.
    template <class Px, class FoundPlace> QUELL_KERNEL auto fetch(Px const& px, FoundPlace const& found) const {
        using Real = typename Px::Real;
        auto past = inner.fetch(px, found);
        auto const place = nearest_place(px, past.where);
        auto const nearest = px.past(place);
        auto const now = px[normal];
        auto then = nearest[normal];
        auto const valid = past.validity > Real(0.f);
        auto const refused = both(valid, invert(detail::counts<Real>(nearest, found)));
        if (any(refused)) {
            auto const where_and_test = found; // a copy: what is passed to a function lives in memory
            then = select(refused, nearest_accepted(px, where_and_test), then);
        }
        auto const differs = both(valid, detail::is_direction(now), invert(cone::same_axes(now, then)));
        if (any(differs)) {
            if constexpr (Px::Scope::kept_channels::template has<ConeLuminance>) {
                turn(px, past, then, now, differs);
            } else { // the signal itself is in cones
                auto const before = past.signal, after = cone::transferred(before, then, now);
                past.signal = select(differs, after, before);
                // Cones that don't overlap pass nothing on.
                past.validity = masked(either(invert(differs), cone::samples(after) > Real(1e-6f)), past.validity);
            }
        }
        return past;
    }

private:
    /// Moves the light to the cones of another normal, as far as a component stays between the past's and those of the samples of the 3x3
    /// around: cones don't know of colours. The past then counts for as many samples as the cones overlap. Not inlined: few pixels need it,
    /// and it would take registers from all.
    template <class Px, class Past, class Real, class Mask>
    QUELL_OUTLINED static constexpr void turn(Px const& px, Past& past, vec3<Real> const& then, vec3<Real> const& now, Mask differs) {
        auto const before = past[cone_luminance], after = cone::transferred(before, then, now);
        auto const samples = cone::samples(after), was = cone::mean(before), is = cone::mean(after);
        auto const known = both(differs, samples > Real(1e-3f));
        detail::Hull<typename Px::Signal> seen(past.signal);
        for_each_neighbour<1>(px, [&](auto const& neighbour, auto inside, int, int) QUELL_INLINED {
            seen.add(neighbour.signal(), both(inside > Real(0.f), invert(neighbour.missing())));
        });
        auto const turned = scale(past.signal, select(both(known, was > Real(0.f)), is / max(was, Real(1e-30f)), Real(1.f)));
        auto const limited = seen.limited(turned);
        past.signal = select(differs, limited, past.signal);
        auto const shaded = luminance(turned), part = select(shaded > Real(0.f), luminance(limited) / max(shaded, Real(1e-30f)), Real(1.f));
        auto const per_sample = 1.f / max(samples, Real(1e-3f));
        auto const in_cones =
            make_value<12, Real>([&](auto i) QUELL_INLINED { return after.at[i] * (i % 2 == 0 ? per_sample * part : per_sample); });
        past.kept.set(cone_luminance, select(known, in_cones, before));
        past.validity = past.validity * select(differs, min(samples, Real(1.f)), Real(1.f));
    }
    /// Normal of the nearest past pixel that the surface test accepts: it weighs most in the interpolation.
    template <class Px, class FoundPlace>
    QUELL_OUTLINED static constexpr vec3<typename Px::Real> nearest_accepted(Px const& px, FoundPlace const& found) {
        using Real = typename Px::Real;
        auto const place = nearest_place(px, found.where);
        vec3<Real> n{Real(0.f), Real(0.f), Real(0.f)};
        Real minimum(9.f);
        for (int j = -1; j <= 1; ++j)
            for (int i = -1; i <= 1; ++i) {
                auto const then = px.past(place, i, j);
                auto const x = place.column - found.where.x + (static_cast<float>(i) + 0.5f),
                           y = place.row - found.where.y + (static_cast<float>(j) + 0.5f);
                auto const distance = fma(x, x, y * y);
                auto const nearer = both(detail::counts<Real>(then, found), distance < minimum);
                n = select(nearer, then[normal], n);
                minimum = select(nearer, distance, minimum);
            }
        return n;
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
