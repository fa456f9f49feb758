#pragma once

#include <live/channels.hpp>
#include <live/core/scenes.hpp>

#include <quell/quell.hpp>

namespace cuda_host {

using namespace quell;

/// A pass of this host's own: traces what a frame has of each pixel, into the frame that is denoised next.
template <class FrameViews> struct Trace {
    static constexpr auto name = "trace";
    live::Scene const* scene; ///< where the pass runs
    live::Cameras cameras;
    live::Tracing tracing;
    FrameViews frame;

    QUELL_LIVE void operator()(AtOnce<float>, int x, int y, int) const { live::TracedPixel(frame, x, y).trace(*scene, cameras, tracing); }
};

/// Traces a scene in which things move, and denoises it, in memory of one storage.
/// @tparam P       a Pipeline or Composite that reads nothing but live::TracedChannels
/// @tparam Storage Device<>; for tests Planar<>
template <class P, class Storage> class Renderer {
    using Input = Frame<typename P::reads, Storage>;
    using FrameViews = Views<Storage, typename P::reads>;

    P denoiser;
    Input frame;
    History<P, Storage> history;
    live::Scene scene; ///< the host's

public:
    /// Whether the frame has a channel.
    template <class C> static constexpr bool has = Input::template has<C>;

    Renderer(P const& p, Extent size) : denoiser(p), frame(size), history(size, p, Storage{}) {}

    /// The scene as it is in a frame, until the next call.
    live::Scene const& scene_of(int number) { return scene = live::moving_scene(0, moment_of(number), moment_of(before(number))); }
    /// The pass that traces a frame; it is what denoise() takes then.
    /// @param where the scene that scene_of() returned, where the pass runs
    Trace<FrameViews> trace(int number, live::Scene const* where) {
        auto const now = camera_of(number);
        frame.camera = live::matrices_of(now), frame.number = number;
        return {where,
                {now, camera_of(before(number))},
                {.frame = static_cast<std::uint32_t>(number + 1)},
                frame.views(typename Input::channels{})};
    }
    /// Denoises the frame. Returns a view of the picture.
    auto denoise(auto const& executor) { return run(denoiser, frame, history, executor); }
    /// The frame's image of a channel.
    template <ChannelTag C> auto const& operator[](C channel) const { return frame[channel]; }

private:
    static int before(int number) { return number > 0 ? number - 1 : 0; }
    static live::Moment moment_of(int number) { return {.time = static_cast<float>(number) / 30}; }
    live::Camera camera_of(int number) const {
        auto orbit = live::first_orbit(0);
        orbit.yaw += 0.004f * static_cast<float>(number);
        return live::camera_of(live::within_reach(0, orbit), frame.size.width, frame.size.height);
    }
};

} // namespace cuda_host
