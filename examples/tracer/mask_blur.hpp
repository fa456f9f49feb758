#pragma once

#include "prepared.hpp"
#include "view.hpp"

#include <quell/image/extent.hpp>

#include <vector>

namespace quell::tracer::detail {

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
