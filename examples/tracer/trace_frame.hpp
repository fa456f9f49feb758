#pragma once

#include "render.hpp"

#include <quell/frame/frame.hpp>

namespace quell::tracer {

/// Lets the tracer write straight into a quell::Frame.
template <class FrameT> struct FrameSink {
    FrameT& frame;

    template <class C, class Value> void put(C channel, int x, int y, Value const& value) { frame[channel].set(x, y, value); }
};

/// The camera of a frame as denoisers want it: with the offset that its samples share.
[[nodiscard]] inline Camera camera_of(PreparedScene const& scene, RenderSettings const& settings) {
    auto camera = scene.description().camera_at(static_cast<float>(settings.frame), settings.size);
    camera.jitter = camera_jitter(settings.jitter, settings.frame);
    return camera;
}

/// Makes a quell::Frame whole: traces all channels that it has, and sets camera, number and shutter. Its size is what counts, not that of
/// the settings.
template <class FrameT> RayCounts trace_frame(PreparedScene& scene, RenderSettings settings, FrameT& frame) {
    settings.size = frame.size;
    FrameSink<FrameT> sink{frame};
    auto const rays = render<typename FrameT::channels>(scene, settings, sink);
    frame.camera = camera_of(scene, settings);
    frame.number = settings.frame;
    frame.shutter = settings.shutter;
    return rays;
}

} // namespace quell::tracer
