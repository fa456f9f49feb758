#pragma once

#include <quell/core/error.hpp>
#include <quell/core/record.hpp>
#include <quell/frame/camera.hpp>
#include <quell/frame/channels.hpp>
#include <quell/image/image_storage.hpp>
#include <quell/image/planar.hpp>

#include <optional>
#include <string>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// One image view for each channel of a set, which kernels take by value.
/// @tparam Storage an ImageStorage
/// @tparam Set     Channels<...>
template <class Storage, class Set> struct Views;
/// One image view for each channel of a set.
template <class Storage, class... Cs> struct Views<Storage, Channels<Cs...>> : detail::Slot<Cs, ViewOf<Storage, Cs>>... {
    using channels = Channels<Cs...>; ///< those that it has
    /// The view of a channel of the set.
    template <ChannelTag C> QUELL_KERNEL auto const& view(C) const { return detail::slot<C>(*this); }
};

/// The input of one frame. It has the channels that the given pipelines read, and no others:
///
///     Frame frame{size, shadows, reflections};           // the union of what both read, in images that the frame owns
///     Frame frame{size, shadows, Borrowed<>{}};          // what `shadows` reads, in the host's memory
///
/// `frame[depth]` is the image of a channel; the constant `has<Depth>` says whether there is one. A copy has images of its own, except that
/// Borrowed images of it still lie in the host's memory; a moved-from frame has none.
/// @tparam Set     Channels<...>
/// @tparam Storage Planar, Interleaved, Borrowed, or the host's own ImageStorage
template <class Set, ImageStorage Storage = Planar<>> struct Frame;

namespace detail {
/// What Frame takes after its size.
template <class T>
concept PartOfFrame = ImageStorage<T> || requires {
    typename T::reads;
};
template <class Set, class Storage> std::true_type a_frame(Frame<Set, Storage> const*);
std::false_type a_frame(void const*);
template <class T> inline constexpr bool is_frame = decltype(a_frame(static_cast<T const*>(nullptr)))::value;
template <class First> inline constexpr bool begins_no_frame = !std::is_convertible_v<First const&, Extent> && !is_frame<First>;
} // namespace detail

/// The input of one frame: an image for each channel of the set, the camera, the frame's number and the shutter.
template <class... Cs, class Storage> struct Frame<Channels<Cs...>, Storage> : detail::Slot<Cs, ImageOf<Storage, Cs>>... {
    using channels = Channels<Cs...>; ///< those that it has
    using storage = Storage;          ///< of its images
    /// Whether it has a channel of that type.
    template <class C> static constexpr bool has = channels::template has<C>;

    Extent size;   ///< pixels
    Camera camera; ///< needed where the pipeline `needs_camera`
    /// The frame's number in its sequence, if known. History starts afresh where numbers do not follow each other.
    std::optional<long long> number;
    /// Shutter time as a part of the time between frames, for motion blur: finite, >= 0. A thing that moves m pixels per frame has a Sweep
    /// of m * shutter pixels. At 0 nothing that moves has history.
    float shutter = 0.5f;

    /// Makes the images of the channels that the pipelines `Ps` read.
    /// @throws Error for a size of no pixels
    template <class... Ps>
    explicit Frame(Extent size_, Ps const&...)
        : detail::Slot<Cs, ImageOf<Storage, Cs>>{ImageOf<Storage, Cs>(divided(checked(size_), Cs::fraction))}..., size(size_) {
        static_assert((detail::PartOfFrame<Ps> && ...),
                      "Frame{size, pipelines..., storage}: what follows the size must be pipelines, and a "
                      "storage as quell/image/image_storage.hpp describes it");
    }
    /// @cond
    template <class First, class... Rest>
        requires(detail::begins_no_frame<First> && !(std::is_arithmetic_v<First> && sizeof...(Rest) < 2)) // Frame({width, height}) is one
    explicit Frame(First const&, Rest const&...) {
        static_assert(sizeof(First) == 0, "Frame{size, pipelines..., storage}: the size comes first, an Extent{width, height}");
    }
    /// @endcond

    /// The image of a channel. One that the frame lacks does not compile, and makes a requires-expression false.
    template <ChannelTag C>
        requires has<C>
    auto& operator[](C) { return detail::slot<C>(*this); }
    /// The image of a channel, to read.
    template <ChannelTag C>
        requires has<C>
    auto const& operator[](C) const { return detail::slot<C>(*this); }
    /// @cond
    // g++ prints the sentence with the template's arguments, clang++ the line of the declaration.
    template <ChannelTag C, detail::Sentence = "this frame has no such channel: construct it with a pipeline that reads the channel">
        requires(!has<C>)
    void operator[](C) const = delete; // this frame has no such channel: construct it with a pipeline that reads the channel
    /// @endcond

    /// Views of some of its channels.
    template <class... Ds> [[nodiscard]] auto views(Channels<Ds...>) const {
        return Views<Storage, Channels<Ds...>>{{(*this)[Ds{}].view()}...};
    }

private:
    static Extent checked(Extent size) {
        if (size.width > 0 && size.height > 0) return size;
        raise_error<Failure>("frame size", to_string(size), "give a width and a height of at least one pixel");
    }
};

namespace detail {
template <class P> struct FrameChannels { using type = reads_of<P>; };
template <class... Ps> using frame_channels = union_of<typename FrameChannels<Ps>::type...>;

template <class... Ps> struct FrameStorage { using type = Planar<>; };
template <class P, class... Ps> struct FrameStorage<P, Ps...> { using type = typename FrameStorage<Ps...>::type; };
template <ImageStorage P, class... Ps> struct FrameStorage<P, Ps...> { using type = P; };
} // namespace detail

/// The channels and the storage follow from the arguments.
template <class... Ps> Frame(Extent, Ps const&...) -> Frame<detail::frame_channels<Ps...>, typename detail::FrameStorage<Ps...>::type>;
/// @cond
template <class First, class... Rest>
    requires detail::begins_no_frame<First> Frame(First const&, Rest const&...)
->Frame<Channels<>>;
/// @endcond

} // namespace quell::inline QUELL_INSTRUCTION_SET
