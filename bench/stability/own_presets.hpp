#pragma once

#include <denoise/denoiser.hpp>

namespace quell::stability {

// What promises compare presets with: the same but for one part.

/// `shadow` that keeps history on surfaces turned away as well.
[[nodiscard]] examples::Preset shadow_without_falloff();
/// `glossy` as if every mirror were flat.
[[nodiscard]] examples::Preset glossy_of_flat_mirrors();
/// `svgf` with SuppressFireflies.
[[nodiscard]] examples::Preset svgf_without_fireflies();
/// `svgf` with its history in half precision.
[[nodiscard]] examples::Preset svgf_in_half();

} // namespace quell::stability
