#pragma once

#include <quell/frame/frame.hpp>
#include <quell/frame/motion_convention.hpp>
#include <quell/frame/pixel_rays.hpp>
#include <quell/frame/remembered.hpp>

#include <glm/mat4x4.hpp>

namespace quell {

namespace detail {
template <class Storage, class Set> struct RememberedViewsOf;
template <class Storage, class... Cs> struct RememberedViewsOf<Storage, Channels<Cs...>> {
    using channels = Channels<Cs...>;
    using type = Views<Storage, Channels<typename Remembered<Cs>::Stored...>>;
};
} // namespace detail

/// All that the kernels of one pass can see.
/// @tparam FrameViews  the frame's channels
/// @tparam MadeViews   what earlier passes of this frame keep or emit
/// @tparam SignalView  the signal being denoised, now and then
/// @tparam KeptViews   what was kept in the previous frame
/// @tparam Then        the channels that the previous frame is remembered by, and their views
/// @tparam raw         whether the signal comes from the host, with missing samples marked by the sign of component 0
/// @tparam camera      whether a policy of the pass says that it `needs_camera`
/// @tparam Vectors     how the host's motion vectors become quell's
template <class FrameViews, class MadeViews, class SignalView, class PastSignalView, class KeptViews, class Then, bool raw, bool camera,
          class Vectors = detail::VectorConversion<MotionConvention{}>>
struct Scope {
    using frame_channels = typename FrameViews::channels;
    using made_channels = typename MadeViews::channels;
    using kept_channels = typename KeptViews::channels;
    using remembered_channels = typename Then::channels;
    static constexpr bool marks_missing = raw;
    static constexpr bool has_camera = camera;
    static constexpr int components = SignalView::components;

    Extent size;
    FrameViews frame;
    MadeViews made;
    SignalView signal;
    PastSignalView signal_then;
    KeptViews kept_then;
    typename Then::type remembered;
    glm::mat4 clip_from_world, clip_from_world_then;
    PixelRays rays, rays_then;
    glm::vec2 jitter, jitter_then;
    float shutter, shutter_then;
    std::int32_t frame_index; ///< for random numbers
    bool has_past;
    [[no_unique_address]] Vectors vectors{};
};

} // namespace quell
