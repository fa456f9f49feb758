#pragma once

#include <quell/frame/channels.hpp>
#include <quell/image/planar.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// What is read of a frame around.
template <class Storage> struct AroundFrame {
    ViewOf<Storage, Albedo> colour{};
    ViewOf<Storage, Depth> depth{};
    ViewOf<Storage, Motion> onward{}; ///< from there to the next frame farther away
    ViewOf<Storage, Motion> toward{}; ///< from there to the next frame nearer by; not finite: not known
    glm::vec2 jitter{0.f};
    bool knows_toward = true; ///< whether there is `toward`
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
