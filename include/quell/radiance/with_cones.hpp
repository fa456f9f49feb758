#pragma once

#include <quell/blend/blend_policy.hpp>
#include <quell/radiance/cones.hpp>

namespace quell {

/// Keeps the history of a colour as incident radiance in six cones (TRMV section 4.3), mixed with the alpha of the inner policy, and gives
/// what these shade to: history can be passed between surfaces that face different ways, and what comes after is a colour that costs no
/// more to filter than any other. For a signal that is one cosine-distributed sample of incident radiance, such as Indirect.
///     Pipeline{indirect, Temporal{FirstValid{SurfaceMotion{}, DualMotion{}}, WithCones{RunningMean{}}, ConeFetch{}}, Spatial{Atrous{}}}
template <class Inner> struct WithCones {
    static_assert(BlendPolicy<Inner>, "WithCones{inner}: `inner` must have blend(px, past), see quell/blend/blend_policy.hpp");
    using reads = decltype(Channels<Normal, IndirectDirection>{} | reads_of<Inner>{});
    using remembers = remembers_of<Inner>;
    using keeps = decltype(keeps_of<Inner>{} | Channels<ConeRadiance>{});
    using emits = emits_of<Inner>;
    Inner inner{};

    QUELL_KERNEL auto blend(auto px, auto past) const {
        auto result = detail::result_of([&]() __attribute__((always_inline)) { return inner.blend(px, past); });
        auto const sample = cone::deposit(px.signal(), px[indirect_direction], px[normal]);
        auto const cones = mix(past[cone_radiance], sample, result.alpha);
        result.value = cone::shade(cones);
        return result.with(cone_radiance, cones);
    }
};
template <class Inner> WithCones(Inner) -> WithCones<Inner>;

} // namespace quell
