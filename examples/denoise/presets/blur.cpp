#include <quell/presets/published.hpp>

#include <denoise/denoiser_of.hpp>
#include <denoise/presets.hpp>

namespace quell::examples {

/// Motion blur from one sample per pixel at a random time. How long the shutter is open, each frame says.
std::vector<Preset> blur_presets() {
    return {
        watched_preset("blur", [] { return quell::presets::blur(radiance); }),
        preset("blur-straight", [] { return quell::presets::blur<StraightTrajectories>(radiance); }),
        preset("blur-bent", [] { return quell::presets::blur<BentTrajectories>(radiance); }),
        preset("blur-wavelet", [] { return quell::presets::blur_wavelet(radiance); }),
        preset("blur-fixed-step", [] { return quell::presets::blur_fixed_step(radiance); }),
        preset("blur-one-step", [] { return quell::presets::blur_one_step(radiance); }),
        preset("blur-paper", [] { return quell::presets::blur_paper(radiance); }),
        preset("blur-no-pre-filter", [] { return quell::presets::blur_no_pre_filter(radiance); }),
        preset("blur-split", [] { return quell::presets::blur_split(); }),
    };
}

} // namespace quell::examples
