#include <quell/presets/published.hpp>

#include <denoise/denoiser_of.hpp>
#include <denoise/presets.hpp>
#include <denoise/two_sided_denoiser.hpp>

namespace quell::examples {

std::vector<Preset> spatiotemporal_presets() {
    return {
        two_sided_preset(
            "general", [](auto... parts) { return quell::presets::general(radiance, Demodulate{}, parts...); },
            [](auto... parts) { return quell::presets::general_joining(radiance, Demodulate{}, parts...); }),
        two_sided_preset(
            "final-frame", [](auto... parts) { return quell::presets::final_frame(radiance, Demodulate{}, parts...); },
            [](auto... parts) { return quell::presets::final_frame_joining(radiance, Demodulate{}, parts...); }),
        watched_preset("svgf", [] { return quell::presets::svgf(radiance, Demodulate{}); }),
        watched_preset("asvgf", [] { return quell::presets::asvgf(radiance, Demodulate{}); }),
        watched_preset("dual-color", [] { return quell::presets::dual_color(radiance, Demodulate{}); }),
    };
}

} // namespace quell::examples
