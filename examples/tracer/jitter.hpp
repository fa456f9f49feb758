#pragma once

#include "math.hpp"

#include <array>
#include <string_view>

namespace quell::tracer {

/// Where in the image a pixel's primary rays go through.
enum class Jitter {
    none,  ///< the pixel's centre
    frame, ///< one offset from it for all samples of a frame, and another one in the next frame, as for temporal antialiasing
    pixel, ///< an offset of its own for every sample, spread as wide as the pixel filter
};

inline constexpr std::array jitters{Jitter::none, Jitter::frame, Jitter::pixel};

[[nodiscard]] std::string_view name_of(Jitter jitter);

/// The offset that all samples of a frame share, as in Camera::jitter: in pixels, y down. Halton points, bases 2 and 3, in [-0.5, 0.5)^2,
/// which repeat after 16 frames. Zero where samples share none.
[[nodiscard]] glm::vec2 camera_jitter(Jitter jitter, int frame);

/// In pixels: how far from the pixel's centre the filter reaches. Cycles calls this the filter's width.
inline constexpr float filter_radius = 1.5f;

/// A sample's offset from the pixel's centre, in pixels, for two numbers in [0, 1): distributed as Cycles' default pixel filter, a
/// Blackman-Harris window in x and in y. The filter is nowhere negative, so that all samples weigh the same.
[[nodiscard]] glm::vec2 filter_offset(glm::vec2 uniform);

} // namespace quell::tracer
