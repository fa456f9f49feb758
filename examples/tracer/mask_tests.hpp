#pragma once

#include "revisit.hpp"

#include <quell/image/extent.hpp>

#include <vector>

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

/// What a camera sees while the shutter is open, at evenly spread times.
class OpenShutter {
public:
    /// The scene has to stand at the frame, its shutter open.
    OpenShutter(PreparedScene const& scene, Extent size);

    /// Whether at any time the pixel shows something that moves in the image, or a shadow or a reflection that does.
    [[nodiscard]] bool has_motion(glm::ivec2 pixel) const;

private:
    struct Moment {
        float time;
        View view;
    };
    [[nodiscard]] bool has_motion(Moment const& moment, glm::ivec2 pixel) const;
    [[nodiscard]] bool has_moving_effect(Moment const& moment, Ray const& ray, Hit const& hit) const;

    PreparedScene const& scene;
    Moment opening, middle, closing;
    std::vector<Moment> moments;
};

} // namespace quell::tracer::detail
