#pragma once

#include <quell/resolve/resolved.hpp>

/// Opt-in: not in quell.hpp.
namespace quell::inline QUELL_INSTRUCTION_SET::presets {

/// Temporal anti-aliasing and upsampling behind a preset: `presets::resolve(presets::general(radiance, Demodulate{}))`. The history's size
/// is the output's.
/// @param pipeline a Pipeline or Composite
/// @param policy   Resolve{...}: kernel, range and axes of the clamp, sharpening, number of frames
template <class P, class Policy = Resolve<>> constexpr auto resolve(P const& pipeline, Policy const& policy = {}) {
    return Resolved{pipeline, policy};
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::presets
