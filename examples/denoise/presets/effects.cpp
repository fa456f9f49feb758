#include <denoise/denoiser_of.hpp>
#include <denoise/presets.hpp>

namespace quell::examples {

/// One effect each: what comes out is the part of the picture that the effect makes; then all of them. These are here since they are of the
/// same kernels, which a file of their own would compile again.
std::vector<Preset> effect_presets() {
    return {
        watched_preset("shadow", [] { return Composite{quell::presets::shadow(visibility)}; }),
        watched_preset("glossy", [] { return Composite{quell::presets::glossy(glossy)}; }),
        watched_preset("mirror-clamp", [] { return Composite{quell::presets::mirror_clamp(glossy)}; }),
        watched_preset("dual-cone", [] { return Composite{quell::presets::dual_cone(indirect)}; }),
        preset("trmv", [] { return quell::presets::trmv(); }),
        preset("trmv-paper", [] { return quell::presets::trmv_paper(); }),
    };
}

} // namespace quell::examples
