#pragma once

#include <quell/frame/cursor/taps.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Dims samples that outshine all their neighbours, before they enter the history and glow for many frames. Limits a sample's luminance to
/// `limit` times that of the brightest usable neighbour in the 3x3 around. Statistics::suppressed sums up the light taken away.
struct SuppressFireflies {
    float limit = 2.f; ///< at least 1

    /// The factor for the sample at the cursor, in (0, 1].
    /// @param px           the cursor
    /// @param here         luminance of the sample
    /// @param luminance_of gives the luminance of a neighbour's sample
    template <class Px, class Luminance> QUELL_KERNEL auto factor(Px const& px, auto here, Luminance&& luminance_of) const {
        using Real = typename Px::Real;
        Real brightest(0.f);
        for_each_neighbour<1>(px, [&](auto neighbour, auto inside, int dx, int dy) QUELL_INLINED {
            if (dx == 0 && dy == 0) return;
            brightest = max(brightest, luminance_of(neighbour) * inside);
        });
        auto const allowed = brightest * limit;
        // All neighbours black: nothing to compare with. Correct images of one sample per pixel have such pixels.
        auto const excessive = both(here > allowed, brightest > Real(0.f));
        return select(excessive, allowed / max(here, Real(1e-30f)), Real(1.f));
    }
};

/// Leaves all samples as they are.
struct NoSuppression {};

} // namespace quell::inline QUELL_INSTRUCTION_SET
