#pragma once

#include <quell/blend/blend_policy.hpp>
#include <quell/radiance/cones.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Keeps the history as incident radiance in six cones (TRMV section 4.3), blended with the inner policy's alpha, and returns the colour
/// that they shade to. So history can pass between surfaces with different normals, and later filters cost no more than for any colour. For
/// a signal that is one cosine-distributed sample of incident radiance per pixel, such as Indirect. A clamp goes outside:
/// `Clamped{WithCones{RunningMean{}}}`.
///
///     Pipeline{indirect, Temporal{FirstValid{SurfaceMotion{}, DualMotion{}}, WithCones{RunningMean{}}, ConeFetch{}}, Spatial{Atrous{}}}
///
/// @tparam Inner a BlendPolicy
template <class Inner> struct WithCones {
    static_assert(BlendPolicy<Inner>, "WithCones{inner}: `inner` must have blend(px, past), see quell/blend/blend_policy.hpp");
    using parts = Parts<Inner>;
    using reads = Channels<Normal, IndirectDirection>;
    using keeps = Channels<ConeRadiance>;
    Inner inner{}; ///< says alpha

    /// The shaded colour, with cone_radiance.
    QUELL_KERNEL auto blend(auto px, auto past) const {
        auto result = result_of([&]() QUELL_INLINED { return inner.blend(px, past); });
        auto const sample = cone::deposit(px.signal(), px[indirect_direction], px[normal]);
        auto before = past[cone_radiance];
        auto const clamped = past.clamped > typename decltype(px)::Real(0.f);
        if (any(clamped)) before = select(clamped, shaded_as(past.signal, before), before);
        auto const cones = mix(before, sample, result.alpha);
        result.value = cone::shade(cones);
        return result.with(cone_radiance, cones);
    }

private:
    /// Cones that shade to a clamped colour. Colours that the clamp has darkened are scaled; to others the same light is added in all
    /// cones.
    template <class V, class Real> QUELL_KERNEL static Components<24, Real> shaded_as(V const& colour, Components<24, Real> const& cones) {
        auto const shaded = cone::shade(cones);
        auto const factor =
            map([](auto to, auto from) QUELL_INLINED { return min(to / max(from, Real(1e-30f)), Real(1.f)); }, colour, shaded);
        auto const added = map([](auto to, auto from) QUELL_INLINED { return max(to - from, Real(0.f)); }, colour, shaded);
        return make_value<24, Real>([&](auto i) QUELL_INLINED {
            constexpr int k = i / 4, c = i % 4;
            if constexpr (c == 3)
                return cones.at[i];
            else
                return fma(cones.at[i], component<c>(factor), component<c>(added) * cones.at[4 * k + 3]);
        });
    }
};
template <class Inner> WithCones(Inner) -> WithCones<Inner>;

} // namespace quell::inline QUELL_INSTRUCTION_SET
