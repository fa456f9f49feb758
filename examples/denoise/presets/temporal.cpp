#include <denoise/denoiser_of.hpp>
#include <denoise/presets.hpp>

namespace quell::examples {

std::vector<Preset> temporal_presets() {
    return {
        preset("none", [] { return quell::presets::none(radiance); }),
        watched_preset("surface", [] { return quell::presets::surface(radiance, Demodulate{}); }),
        watched_preset("surface-clamp", [] { return quell::presets::surface_clamp(radiance, Demodulate{}); }),
    };
}

} // namespace quell::examples
