#pragma once

#include "compiled_preset.hpp"

#include <quell/frame/channels.hpp>

namespace quell_library {

/// What is done and kept before a preset runs a guide of which is made steady first: a sentence before its plan.
/// @tparam C the guide: Depth or Albedo
template <class C> [[nodiscard]] std::string plan_of_steady();

/// A compiled denoiser of which a noisy guide is accumulated along its motion first (quell::SteadyGuides). It takes one frame at a time.
/// @tparam C       the guide: Depth or Albedo
/// @param denoiser runs then
/// @param channels that it reads: motion among them, and the guide
/// @param size     of the frames
/// @throws quell::Error, std::bad_alloc
template <class C>
[[nodiscard]] std::unique_ptr<CompiledDenoiser> with_steady_guide(std::unique_ptr<CompiledDenoiser> denoiser,
                                                                  std::vector<ReadChannel> const& channels, quell::Extent size,
                                                                  Parallel const& parallel, Memory const& memory);

} // namespace quell_library
