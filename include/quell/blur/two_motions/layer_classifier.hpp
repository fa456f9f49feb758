#pragma once

#include <quell/blur/two_motions/pair_guide.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Assigns a sample to the foreground or the background of a LayerMotions.
template <class Trajectories, class Real> struct LayerClassifier {
    using ScreenMotion = detail::ScreenMotion<Trajectories, Real>;
    ScreenMotion front, back;
    decltype(Real(0.f) < Real(0.f)) two; ///< false where there is only a background

    template <class Pair>
    QUELL_KERNEL explicit LayerClassifier(Pair const& pair)
        : front(one_of<0>(pair)), back(one_of<1>(pair)), two(inverse_depth_of(front) > Real(0.f)) {
        auto const apart = 2.f / max(squared_difference(front, back), Real(1e-12f));
        auto const f = speed_of(front), b = speed_of(back);
        towards = {(f.x - b.x) * apart, (f.y - b.y) * apart};
        middle = fma((f.x + b.x) * 0.5f, towards.x, (f.y + b.y) * 0.5f * towards.y);
        auto const gap = abs(inverse_depth_of(front) - inverse_depth_of(back));
        per_gap = masked(gap > min(inverse_depth_of(front), inverse_depth_of(back)) * min_depth_gap, 1.f / max(gap, Real(1e-9f)));
    }
    /// By velocity, and also by depth where the two differ in it.
    template <class M> QUELL_KERNEL auto is_front(M const& m) const {
        auto const speed = speed_of(m);
        auto const by_motion = clamp(fma(speed.x, towards.x, fma(speed.y, towards.y, -middle)), Real(-1.f), Real(1.f));
        auto const by_depth = abs(inverse_depth_of(m) - inverse_depth_of(back)) - abs(inverse_depth_of(m) - inverse_depth_of(front));
        return both(two, fma(by_depth, per_gap, by_motion) > Real(0.f));
    }

private:
    vec2<Real> towards; ///< its dot product with the foreground's velocity is `middle` + 1, with the background's `middle` - 1
    Real middle, per_gap;
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
