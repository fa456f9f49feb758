#include "own_presets.hpp"

#include <library/compile_preset.hpp>

namespace quell::stability {

using examples::Preset;
using quell_library::one_sided;

namespace {
Preset preset(std::string name, quell_library::Way const& way) { return {.name = std::move(name), .usual = way}; }
} // namespace

Preset shadow_without_falloff() {
    return preset("shadow-without-falloff", one_sided([] {
                      auto const [splat, change, bilateral, temporal, clean_up] = presets::shadow(visibility).stages;
                      auto const& clamped = temporal.blending;
                      auto const& accumulated = clamped.inner.inner.inner; // within a WithCleanUp and a NonPlanarFalloff
                      return Composite{Pipeline{visibility, splat, change, bilateral,
                                                Temporal{temporal.motion, Clamped{WithCleanUp{accumulated}, clamped.range}, temporal.fetch},
                                                clean_up}};
                  }));
}

Preset glossy_of_flat_mirrors() {
    return preset("glossy-flat-mirror", one_sided([] { return Composite{presets::glossy<FlatMirror>(glossy)}; }));
}

Preset svgf_without_fireflies() {
    return preset("svgf-suppress-fireflies", one_sided([] { return presets::svgf(radiance, Demodulate{}, SuppressFireflies{}); }));
}

Preset svgf_in_half() {
    return preset("svgf-half", one_sided<Planar<Float16>>([] { return presets::svgf(radiance, Demodulate{}); }));
}

} // namespace quell::stability
