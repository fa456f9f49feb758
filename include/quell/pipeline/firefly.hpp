#pragma once

#include <quell/frame/cursor/taps.hpp>

namespace quell {

/// Dims single samples that outshine everything around them before they enter the history, where they would glow for many frames. A
/// sample's luminance is limited to `limit` times the brightest usable neighbour's. What this takes away is summed up in
/// Statistics::suppressed.
struct SuppressFireflies {
    float limit = 2.f; ///< at least 1

    /// The factor in (0, 1] for the sample at the cursor, by its luminance and its neighbours'.
    template <class Px, class Luminance> QUELL_KERNEL auto factor(Px const& px, auto here, Luminance&& luminance_of) const {
        using Real = typename Px::Real;
        Real brightest(0.f);
        for_each_neighbour<1>(px, [&](auto neighbour, auto inside, int dx, int dy) QUELL_INLINED {
            if (dx == 0 && dy == 0) return;
            brightest = max(brightest, luminance_of(neighbour) * inside);
        });
        auto const allowed = brightest * limit;
        // Alone in the dark is how a correct 1-sample image looks too: without a bright neighbour there is nothing to measure by.
        auto const excessive = both(here > allowed, brightest > Real(0.f));
        return select(excessive, allowed / max(here, Real(1e-30f)), Real(1.f));
    }
};

struct NoSuppression {};

} // namespace quell
