#pragma once

#include "prepared.hpp"

#include <quell/frame/frame.hpp>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/matrix.hpp>

namespace quell::tracer {

/// Lets the tracer write straight into a quell::Frame.
template <class FrameT> struct FrameSink {
    FrameT& frame;

    template <class C, class Value> void put(C channel, int x, int y, Value const& value) { frame[channel].set(x, y, value); }
};

/// The tracer's camera in the matrices of quell::Camera.
[[nodiscard]] inline Camera camera_of(CameraPose const& pose, Extent size) {
    float const aspect = static_cast<float>(size.width) / static_cast<float>(size.height);
    return {glm::inverse(pose.world_from_camera), glm::perspective(pose.vertical_field_of_view, aspect, 0.1f, 1000.f), {}};
}

} // namespace quell::tracer
