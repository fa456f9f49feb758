#pragma once

#include <quell/image/planar.hpp>
#include <quell/link/colours/anti_aliased.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// A frame as anti_alias() sees it, as views.
/// @tparam Storage of its images
template <class Storage = Planar<>> struct ColouredFrame {
    ViewOf<Storage, Albedo> colour{};  ///< what light is multiplied by
    ViewOf<Storage, Depth> depth{};    ///< as the channel
    ViewOf<Storage, Motion> motion{};  ///< to the frame before, in pixels, without jitter
    ViewOf<Storage, Motion> to_next{}; ///< the same to the frame after; not finite: not known
    glm::vec2 jitter{0.f};             ///< where the samples lie, from the pixels' centres
    bool knows_next = true;            ///< whether there is `to_next`
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
