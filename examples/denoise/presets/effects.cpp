#include <quell/presets/published.hpp>

#include <denoise/denoiser_of.hpp>
#include <denoise/presets.hpp>

namespace quell::examples {

namespace {

/// What comes out is the part of the picture that one effect makes.
Preset part(Preset preset) {
    preset.is_part = true;
    return preset;
}

} // namespace

/// One effect each, then all of them. These are here since they are of the same kernels, which a file of their own would compile again.
std::vector<Preset> effect_presets() {
    return {
        part(watched_preset("shadow", [] { return Composite{quell::presets::shadow(visibility)}; })),
        part(watched_preset("glossy", [] { return Composite{quell::presets::glossy(glossy)}; })),
        part(watched_preset("mirror-clamp", [] { return Composite{quell::presets::mirror_clamp(glossy)}; })),
        part(watched_preset("dual-cone", [] { return Composite{quell::presets::dual_cone(indirect)}; })),
        preset("trmv", [] { return quell::presets::trmv(); }),
        preset("trmv-paper", [] { return quell::presets::trmv_paper(); }),
    };
}

} // namespace quell::examples
