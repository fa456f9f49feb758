#pragma once

#include <quell/motion/history_fetch.hpp>
#include <quell/radiance/cones.hpp>

namespace quell {

/// A history fetch for Cones: what was found on a surface with another normal is passed from its cones to this pixel's, by their overlap.
///     Temporal{FirstValid{SurfaceMotion{}, DualMotion{}}, RunningMean{}, ConeFetch{}}
struct ConeFetch {
    using reads = Channels<Normal>;
    using remembers = Channels<Normal>;
    Bilinear inner{};

    template <class Px, class FoundPlace> QUELL_KERNEL auto fetch(Px const& px, FoundPlace const& found) const {
        using Real = typename Px::Real;
        auto past = inner.fetch(px, found);
        auto const place = nearest_place(px, past.where);
        auto const now = px[normal], then = px.past(place)[normal];
        auto const differs = both(past.validity > Real(0.f), invert(cone::same_axes(now, then)));
        if (any(differs)) {
            if constexpr (Px::Scope::kept_channels::template has<ConeRadiance>) {
                auto const before = past[cone_radiance];
                past.kept.set(cone_radiance, select(differs, cone::transferred(before, then, now), before));
            } else {
                auto const before = past.signal;
                past.signal = select(differs, cone::transferred(before, then, now), before);
            }
        }
        return past;
    }
};

} // namespace quell
