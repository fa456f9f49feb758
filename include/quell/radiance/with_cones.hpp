#pragma once

#include <quell/blend/blend_policy.hpp>
#include <quell/radiance/cones.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Keeps beside the history how its light is spread over six cones of directions (TRMV section 4.3), blended with the inner policy's alpha.
/// So history can pass between surfaces with different normals: ConeFetch makes it as bright as the other normal is lit. The signal is the
/// mean of the samples; ConeGather shades it by the cones. Cones hold luminance: colour is the signal's, as for light of one colour it
/// would be in cones too. For a signal that is one cosine-distributed sample of incident radiance per pixel, such as Indirect. A clamp goes
/// outside: `Clamped{WithCones{RunningMean{}}}`.
///
///     Pipeline{indirect, Temporal{FirstValid{SurfaceMotion{}, DualMotion{}}, WithCones{RunningMean{}}, ConeFetch{}},
///              Spatial{ConeGather{}}, Spatial{Atrous{}}}
///
/// @tparam Inner a BlendPolicy
template <class Inner> struct WithCones {
    static_assert(BlendPolicy<Inner>, "WithCones{inner}: `inner` must have blend(px, past), see quell/blend/blend_policy.hpp");
    using parts = Parts<Inner>;
    using reads = Channels<Normal, IndirectDirection>;
    using keeps = Channels<ConeLuminance>;
    static constexpr int farthest_tap = 0;
    Inner inner{}; ///< says alpha

    /// The inner policy's mean, with cone_luminance.
    QUELL_KERNEL auto blend(auto px, auto past) const {
        auto const result = result_of([&]() QUELL_INLINED { return inner.blend(px, past); });
        auto const sample = cone::deposit(luminance(px.signal()), px[indirect_direction], px[normal]);
        auto before = past[cone_luminance];
        auto const clamped = past.clamped > typename decltype(px)::Real(0.f);
        if (any(clamped)) before = select(clamped, as_bright_as(luminance(past.signal), before), before);
        return result.with(cone_luminance, mix(before, sample, result.alpha));
    }

private:
    /// Cones of a mean that a clamp has changed. Those that it has darkened are scaled; to others the same light is added in all cones.
    template <class Real> QUELL_KERNEL static Components<12, Real> as_bright_as(Real wanted, Components<12, Real> const& cones) {
        auto const mean = cone::mean(cones);
        auto const factor = clamp(wanted / max(mean, Real(1e-30f)), Real(0.f), Real(1.f)), added = max(wanted - mean, Real(0.f));
        return make_value<12, Real>([&](auto i) QUELL_INLINED {
            if constexpr (i % 2 == 1)
                return cones.at[i];
            else
                return fma(cones.at[i], factor, added * cones.at[i + 1]);
        });
    }
};
template <class Inner> WithCones(Inner) -> WithCones<Inner>;

} // namespace quell::inline QUELL_INSTRUCTION_SET
