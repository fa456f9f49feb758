#pragma once

#include "compiled_preset.hpp"

namespace quell_library {

/// Guides that can be made steady before a denoiser reads them: quell_settings::steady_guides of quell.h.
struct SteadyChoice {
    bool depth = false, albedo = false;

    explicit operator bool() const { return depth || albedo; }
};

/// A compiled denoiser of which noisy guides are accumulated along their motion first (quell::SteadyGuides). It takes one frame at a time.
/// @param denoiser runs then
/// @param channels that it reads: motion among them, and the guides
/// @param size     of the frames
/// @throws quell::Error, std::bad_alloc
[[nodiscard]] std::unique_ptr<CompiledDenoiser> with_steady_guides(std::unique_ptr<CompiledDenoiser> denoiser,
                                                                   std::vector<ReadChannel> const& channels, SteadyChoice which,
                                                                   quell::Extent size, Parallel const& parallel, Memory const& memory);

} // namespace quell_library
