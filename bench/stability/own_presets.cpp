#include "own_presets.hpp"

#include <denoise/denoiser_of.hpp>

namespace quell::stability {

using examples::preset;

examples::Preset shadow_without_falloff() {
    return preset("shadow-without-falloff", [] {
        auto const [splat, change, bilateral, temporal, clean_up] = presets::shadow(visibility).stages;
        auto const& clamped = temporal.blending;
        auto const& accumulated = clamped.inner.inner.inner; // within a WithCleanUp and a NonPlanarFalloff
        return Composite{Pipeline{visibility, splat, change, bilateral,
                                  Temporal{temporal.motion, Clamped{WithCleanUp{accumulated}, clamped.range}, temporal.fetch}, clean_up}};
    });
}

examples::Preset glossy_of_flat_mirrors() {
    return preset("glossy-flat-mirror", [] { return Composite{presets::glossy<FlatMirror>(glossy)}; });
}

examples::Preset svgf_without_fireflies() {
    return preset("svgf-suppress-fireflies", [] { return presets::svgf(radiance, Demodulate{}, SuppressFireflies{}); });
}

examples::Preset svgf_in_half() {
    return preset<Planar<Float16>>("svgf-half", [] { return presets::svgf(radiance, Demodulate{}); });
}

} // namespace quell::stability
