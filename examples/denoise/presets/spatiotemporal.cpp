#include <denoise/denoiser_of.hpp>
#include <denoise/presets.hpp>

namespace quell::examples {

std::vector<Preset> spatiotemporal_presets() {
    return {
        watched_preset("general", [] { return quell::presets::general(radiance, Demodulate{}); }),
        watched_preset("svgf", [] { return quell::presets::svgf(radiance, Demodulate{}); }),
        watched_preset("asvgf", [] { return quell::presets::asvgf(radiance, Demodulate{}); }),
        watched_preset("dual-color", [] { return quell::presets::dual_color(radiance, Demodulate{}); }),
    };
}

} // namespace quell::examples
