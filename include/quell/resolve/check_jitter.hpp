#pragma once

#include <quell/core/error.hpp>
#include <quell/core/value.hpp>

#include <string>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// @param jitter of a frame's camera
/// @param most   how far samples may lie from their pixels' centres, in pixels
/// @throws Error for a jitter beyond that, or one that is not finite
inline void check_jitter(glm::vec2 jitter, float most) {
    auto const is_in_range = [&](float a) { return is_finite(a) && a >= -most && a <= most; };
    if (!is_in_range(jitter.x) || !is_in_range(jitter.y))
        raise_error<Failure>("run: frame.camera.jitter", std::to_string(jitter.x) + ", " + std::to_string(jitter.y),
                             "give the samples' offset from the pixels' centres, in pixels of the frame");
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
