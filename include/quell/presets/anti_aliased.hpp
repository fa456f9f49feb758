#pragma once

#include <quell/link/colours/anti_aliased.hpp>

/// Opt-in: not in quell.hpp.
namespace quell::inline QUELL_INSTRUCTION_SET::presets {

/// A denoiser whose picture is put together with anti-aliased colours: its light is what the albedo leaves of the picture, and is
/// multiplied by albedos of this frame and of the one before it (AntiAliased). Edges between surfaces become as mixed as their pixels are
/// covered, those before the sky and of emitters too, whose albedo is 1:
///
///     constexpr auto denoise = presets::anti_aliased(presets::general(radiance, Demodulate{})); // a Chain
///
/// Samples of other places come by motion, or by frame.camera.jitter, which is at most 8 pixels.
/// @param denoiser a Chain, or what may stand first in one
/// @param policy   AntiAliased{...}; that of one sample per pixel, where there is none
template <class D> constexpr auto anti_aliased(D const& denoiser, AntiAliased const& policy = AntiAliased::of_samples(1)) {
    return detail::with_link(denoiser, Pipeline{denoised, Supplied<D::motion_convention>{}, Spatial{policy}});
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::presets
