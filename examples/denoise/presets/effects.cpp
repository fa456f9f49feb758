#include <denoise/denoiser_of.hpp>
#include <denoise/presets.hpp>

namespace quell::examples {

/// One effect each: what comes out is the part of the picture that the effect makes.
std::vector<Preset> effect_presets() {
    return {
        watched_preset("shadow", [] { return Composite{quell::presets::shadow(visibility)}; }),
        watched_preset("glossy", [] { return Composite{quell::presets::glossy(glossy)}; }),
        watched_preset("mirror-clamp", [] { return Composite{quell::presets::mirror_clamp(glossy)}; }),
        watched_preset("dual-cone", [] { return Composite{quell::presets::dual_cone(indirect)}; }),
    };
}

} // namespace quell::examples
