#pragma once

#include "surface.hpp"
#include "view.hpp"

namespace quell::tracer {

/// A point of a surface that was hit at some other frame, as it is at the frame where the scene stands, seen from that frame's camera.
struct Revisited {
    Ray ray; ///< from the eye to the point, and no further
    Hit hit;
    Surface surface;
};

[[nodiscard]] Revisited revisit(PreparedScene const& scene, View const& view, Hit const& hit, float time = 0);

/// Whether the camera sees the point: inside the image, before the camera, and nothing in the way.
[[nodiscard]] bool is_seen(PreparedScene const& scene, View const& view, Extent size, Revisited const& point);

} // namespace quell::tracer
