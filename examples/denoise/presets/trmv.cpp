#include <denoise/denoiser_of.hpp>
#include <denoise/presets.hpp>

namespace quell::examples {

std::vector<Preset> trmv_presets() {
    return {
        preset("trmv", [] { return quell::presets::trmv(); }),
        preset("trmv-paper", [] { return quell::presets::trmv_paper(); }),
    };
}

} // namespace quell::examples
