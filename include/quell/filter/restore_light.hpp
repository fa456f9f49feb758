#pragma once

#include <quell/filter/atrous.hpp>

/// The last passes of LocalRegression: they give back the light that its fit has lost.
namespace quell::inline QUELL_INSTRUCTION_SET {

/// Mean luminance over a window: of the pilot (x), which has all of the light, and of the fit (y).
struct LightOfPilotAndFit : InternalChannel<2> {
    static constexpr auto name = "light_of_pilot_and_fit";
};
inline constexpr LightOfPilotAndFit light_of_pilot_and_fit;
/// The largest factor by which a fit may be multiplied or divided so that it stays between the least and the greatest value of its window;
/// 1 without a fit.
struct FreedomOfFit : InternalChannel<1> {
    static constexpr auto name = "freedom_of_fit";
};
inline constexpr FreedomOfFit freedom_of_fit;

namespace detail {
/// Mean of five pixels of a row or a column.
struct LightLine {
    static constexpr auto name = "light of pilot and fit";
    using reads = Channels<LightOfPilotAndFit>;
    using emits = Channels<LightOfPilotAndFit>;
    int step;
    bool vertical;

    constexpr int farthest_tap() const { return 2 * step; }

    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        Real pilot(0.f), fit(0.f);
        for_each_of_five(px, step, vertical, [&](auto const& neighbour, auto inside) QUELL_INLINED {
            auto const light = neighbour[light_of_pilot_and_fit];
            pilot = pilot + masked(inside, light.x);
            fit = fit + masked(inside, light.y);
        });
        return emitted<Real>(light_of_pilot_and_fit, vec2<Real>{pilot * 0.2f, fit * 0.2f});
    }
};
/// Scales the fit to the pilot's mean luminance around the pixel.
struct RestoreLight {
    static constexpr auto name = "restore light";
    using reads = Channels<LightOfPilotAndFit, FreedomOfFit>;
    static constexpr int farthest_tap = 0;

    QUELL_KERNEL auto filter(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const light = px[light_of_pilot_and_fit];
        auto const freedom = max(px[freedom_of_fit], Real(1.f));
        auto const known = both(light.x > Real(0.f), light.y > Real(0.f));
        auto const wanted = clamp(light.x / max(light.y, Real(1e-30f)), 1.f / freedom, freedom);
        return Result{finite_or(scale(px.signal(), select(known, wanted, Real(1.f))), px.signal())};
    }
};
} // namespace detail

} // namespace quell::inline QUELL_INSTRUCTION_SET
