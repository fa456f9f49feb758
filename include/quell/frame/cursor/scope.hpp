#pragma once

#include <quell/frame/cursor/missing_mark.hpp>
#include <quell/frame/frame.hpp>
#include <quell/frame/motion_convention.hpp>
#include <quell/frame/pixel_rays.hpp>
#include <quell/frame/remembered.hpp>

#include <glm/mat4x4.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {
template <class Storage, class Set> struct RememberedViewsOf;
template <class Storage, class... Cs> struct RememberedViewsOf<Storage, Channels<Cs...>> {
    using channels = Channels<Cs...>;
    using type = Views<Storage, Channels<typename Remembered<Cs>::Stored...>>;
};
} // namespace detail

/// Properties of a pass.
struct PassTraits {
    bool marks_missing = false;     ///< the signal marks missing samples
    bool has_camera = false;        ///< a policy of the pass declares `needs_camera`
    bool reads_past_signal = false; ///< it looks at the signal of the last frame
    int fraction = 1;               ///< size of the pass = frame size / fraction, rounded up
};

/// Everything that the kernels of one pass can read. `_then` means of the previous frame.
/// @tparam FrameViews     views of the host's channels
/// @tparam MadeViews      views of channels that earlier passes of this frame keep or emit
/// @tparam SignalView     view of the signal being denoised
/// @tparam PastSignalView view of the signal in the history
/// @tparam KeptViews      views of channels kept in the previous frame
/// @tparam Then           `channels`: the remembered channels; `type`: their views
/// @tparam traits         of the pass
/// @tparam Vectors        converts the host's motion vectors to quell's
template <class FrameViews, class MadeViews, class SignalView, class PastSignalView, class KeptViews, class Then, PassTraits traits,
          class Vectors = detail::VectorConversion<MotionConvention{}>>
struct Scope {
    using frame_channels = typename FrameViews::channels;                 ///< of the host
    using made_channels = typename MadeViews::channels;                   ///< of earlier passes
    using kept_channels = typename KeptViews::channels;                   ///< kept in the previous frame
    using remembered_channels = typename Then::channels;                  ///< of the previous frame
    static constexpr bool marks_missing = traits.marks_missing;           ///< see PassTraits
    static constexpr bool has_camera = traits.has_camera;                 ///< see PassTraits
    static constexpr bool reads_past_signal = traits.reads_past_signal;   ///< see PassTraits
    static constexpr int fraction = traits.fraction;                      ///< see PassTraits
    static constexpr int components = SignalView::components;             ///< of the signal
    using mark = detail::MissingMark<detail::keeps_all_bits<SignalView>>; ///< of a missing sample

    Extent size;                               ///< of the pass, in pixels
    Extent frame_size{};                       ///< of the frame
    FrameViews frame;                          ///< the host's channels
    MadeViews made{};                          ///< made by earlier passes
    SignalView signal{};                       ///< being denoised
    PastSignalView signal_then{};              ///< in the history
    KeptViews kept_then{};                     ///< kept in the previous frame
    typename Then::type remembered{};          ///< channels of the previous frame
    glm::mat4 clip_from_world{1.f},            ///< world space to clip space, without jitter
        clip_from_world_then{1.f};             ///< in the previous frame
    PixelRays rays{},                          ///< of this frame
        rays_then{};                           ///< of the previous frame
    glm::vec2 jitter{0.f},                     ///< of this frame, in pixels
        jitter_then{0.f};                      ///< of the previous frame
    float shutter = 0.f,                       ///< of this frame, as a part of the time between frames
        shutter_then = 0.f;                    ///< of the previous frame
    std::int32_t frame_index = 0;              ///< seed of random numbers
    bool has_past = false;                     ///< false in the first frame after a reset
    QUELL_NO_UNIQUE_ADDRESS Vectors vectors{}; ///< converts motion vectors
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
