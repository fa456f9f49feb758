#pragma once

#include "compiled_preset.hpp"

namespace quell_library {

/// Whether temporal anti-aliasing can be put behind a compiled preset: what comes out must have one component, or be a colour, with alpha
/// or without.
[[nodiscard]] bool can_resolve(Way const& way);

/// The channels that it then reads: the preset's own, and behind them motion and depth, as far as the preset does not read them.
[[nodiscard]] std::vector<ReadChannel> channels_of_resolved(Way const& way);

/// What it does then: the preset's plan, and what comes behind it.
[[nodiscard]] std::string plan_of_resolved(Way const& way);

/// A compiled preset with temporal anti-aliasing behind it (quell::presets::resolve), whose output may be larger than the frames. Its
/// frames have the channels of channels_of_resolved(), and a camera that says their jitter. Their size may change: what was resolved stays.
/// It is compiled for numbers of components, and not for each preset.
/// @param denoiser made by the way
/// @param way      one that can_resolve()
/// @param size     of the frames
/// @param output   what comes out has this size
/// @throws quell::Error, std::bad_alloc
[[nodiscard]] std::unique_ptr<CompiledDenoiser> make_resolved(std::unique_ptr<CompiledDenoiser> denoiser, Way const& way,
                                                              quell::Extent size, quell::Extent output, Parallel const& parallel,
                                                              Memory const& memory);

} // namespace quell_library
