#pragma once

#include "revisit.hpp"

#include <quell/image/extent.hpp>

namespace quell::tracer::detail {

/// A pixel's point at one of the frames that its mask looks at, and the cameras of that frame and the one before.
struct MaskPoint {
    PreparedScene const& scene;
    Extent size;
    View const &view, &view_before;
    Hit const& hit;
};

/// Whether a shadow lies on the point that moves over its surface: by the shadow's motion (TRMV eq. 3) less the surface's own.
[[nodiscard]] bool has_moving_shadow(MaskPoint const& point);

/// Whether the point reflects something whose virtual image moves differently from the point itself.
[[nodiscard]] bool has_moving_reflection(MaskPoint const& point);

/// Whether the camera doesn't see the point.
[[nodiscard]] bool is_hidden(MaskPoint const& point);

} // namespace quell::tracer::detail
