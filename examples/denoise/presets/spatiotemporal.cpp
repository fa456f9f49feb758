#include <denoise/denoiser_of.hpp>
#include <denoise/presets.hpp>

namespace quell::examples {

std::vector<Preset> spatiotemporal_presets() {
    return {
        preset("svgf", [] { return quell::presets::svgf(radiance, Demodulate{}); }),
    };
}

} // namespace quell::examples
