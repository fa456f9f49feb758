#pragma once

#include <quell/resolve/remodulated.hpp>

/// Opt-in: not in quell.hpp.
namespace quell::inline QUELL_INSTRUCTION_SET::presets {

/// Colours anti-aliased by those of the last frames, behind a preset: `presets::anti_aliased(presets::general(radiance, Demodulate{}))`.
/// @tparam frames  how many frames of the past are kept, 0 to 4
/// @param pipeline a Pipeline or Composite
/// @param policy   AntiAliased{...}; that of one sample per pixel, where there is none
template <int frames = 1, class P> constexpr auto anti_aliased(P const& pipeline, AntiAliased const& policy = AntiAliased::of_samples(1)) {
    return Remodulated<P, frames>{pipeline, policy};
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::presets
