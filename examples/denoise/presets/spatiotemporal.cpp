#include <denoise/denoiser_of.hpp>
#include <denoise/presets.hpp>

namespace quell::examples {

std::vector<Preset> spatiotemporal_presets() {
    return {
        preset("svgf", [] { return quell::presets::svgf(radiance, Demodulate{}); }),
        preset("asvgf", [] { return quell::presets::asvgf(radiance, Demodulate{}); }),
        preset("dual-color", [] { return quell::presets::dual_color(radiance, Demodulate{}); }),
    };
}

} // namespace quell::examples
