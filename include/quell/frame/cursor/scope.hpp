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

/// What a pass may see beside channels.
struct PassTraits {
    bool marks_missing = false; ///< the signal comes from the host, with missing samples marked by the sign of component 0
    bool has_camera = false;    ///< a policy of the pass says that it `needs_camera`
    int fraction = 1;           ///< of the frame's width and height, at which the pass runs
};

/// All that the kernels of one pass can see.
/// @tparam FrameViews  the frame's channels
/// @tparam MadeViews   what earlier passes of this frame keep or emit
/// @tparam SignalView  the signal being denoised, now and then
/// @tparam KeptViews   what was kept in the previous frame
/// @tparam Then        the channels that the previous frame is remembered by, and their views
/// @tparam traits      of the pass
/// @tparam Vectors     how the host's motion vectors become quell's
template <class FrameViews, class MadeViews, class SignalView, class PastSignalView, class KeptViews, class Then, PassTraits traits,
          class Vectors = detail::VectorConversion<MotionConvention{}>>
struct Scope {
    using frame_channels = typename FrameViews::channels;
    using made_channels = typename MadeViews::channels;
    using kept_channels = typename KeptViews::channels;
    using remembered_channels = typename Then::channels;
    static constexpr bool marks_missing = traits.marks_missing;
    static constexpr bool has_camera = traits.has_camera;
    static constexpr int fraction = traits.fraction;
    static constexpr int components = SignalView::components;

    Extent size; ///< of the pass
    FrameViews frame;
    MadeViews made{};
    SignalView signal{};
    PastSignalView signal_then{};
    KeptViews kept_then{};
    typename Then::type remembered{};
    glm::mat4 clip_from_world{1.f}, clip_from_world_then{1.f};
    PixelRays rays{}, rays_then{};
    glm::vec2 jitter{0.f}, jitter_then{0.f};
    float shutter = 0.f, shutter_then = 0.f;
    std::int32_t frame_index = 0; ///< for random numbers
    bool has_past = false;
    [[no_unique_address]] Vectors vectors{};
};

} // namespace quell
