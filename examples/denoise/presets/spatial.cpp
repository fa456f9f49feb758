#include <denoise/denoiser_of.hpp>
#include <denoise/presets.hpp>

namespace quell::examples {

std::vector<Preset> spatial_presets() {
    return {
        preset("atrous", [] { return quell::presets::atrous(radiance, Demodulate{}); }),
    };
}

} // namespace quell::examples
