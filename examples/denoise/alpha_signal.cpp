#include <denoise/alpha_signal.hpp>
#include <denoise/film_alpha.hpp>
#include <denoise/presets.hpp>

namespace quell::examples {

Preset const* preset_of_alpha(Preset const& preset) { return preset.two_sided ? &preset : find_preset("general"); }

void AlphaSignal::look_ahead(Preset const& preset, Extent size, int threads, SeenFrame& seen, LightSplit const& split) {
    if (split.own_alpha.empty()) return;
    remembers = static_cast<bool>(preset.two_sided);
    if (!denoiser) denoiser = std::make_unique<Denoiser>(way_of(*preset_of_alpha(preset)), size, threads);
    denoiser->look_ahead(seen.image, split.names_of_own_alpha, seen.number, seen.guides);
}

std::vector<float> AlphaSignal::complete(std::vector<float> with_light, std::vector<float> const& given, SeenFrame const& seen,
                                         LightSplit const& split) {
    bool const has_own = !split.own_alpha.empty();
    if (has_own) carried = with_light;
    auto& alpha = with_light;
    if (has_own) {
        if (!remembers) denoiser->forget();
        auto const own = denoiser->denoise(seen.image, split.names_of_own_alpha, seen.number);
        for (std::size_t i = 0; i < alpha.size(); ++i)
            if (split.own_alpha[i]) alpha[i] += own.at(0, i);
    }
    if (split.shares_alpha || has_own) limit_alpha(alpha, given, seen.image.size);
    if (!has_own) carried = alpha;
    return alpha;
}

} // namespace quell::examples
