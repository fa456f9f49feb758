#pragma once

#include <quell/core/error.hpp>
#include <quell/core/record.hpp>
#include <quell/frame/camera.hpp>
#include <quell/frame/channels.hpp>
#include <quell/image/image_storage.hpp>
#include <quell/image/planar.hpp>

#include <optional>
#include <string>

namespace quell {

/// What kernels see of several images: one view for each channel of the set, and nothing else.
template <class Storage, class Set> struct Views;
template <class Storage, class... Cs> struct Views<Storage, Channels<Cs...>> : detail::Slot<Cs, ViewOf<Storage, Cs>>... {
    using channels = Channels<Cs...>;
    template <ChannelTag C> QUELL_KERNEL auto const& view(C) const { return detail::slot<C>(*this); }
};

/// The input of one frame: exactly the channels of the set, which follow from the pipelines that it is made for:
///     Frame frame{size, shadows, reflections};           // the union of what the two read, in images of its own
///     Frame frame{size, shadows, Borrowed<>{}};          // the same in the host's memory
/// `frame[depth]` is that channel's image. A channel that no pipeline reads does not exist.
/// @tparam Set     Channels<...>
/// @tparam Storage where the images live: Planar, Interleaved, Borrowed, or the host's own ImageStorage
template <class Set, ImageStorage Storage = Planar<>> struct Frame;

template <class... Cs, class Storage> struct Frame<Channels<Cs...>, Storage> : detail::Slot<Cs, ImageOf<Storage, Cs>>... {
    using channels = Channels<Cs...>;
    using storage = Storage;

    Extent size;
    Camera camera;
    /// The frame's number in its sequence. Where it is given and does not follow the last one, history starts afresh.
    std::optional<long long> number;
    /// The part of the time between frames during which the shutter is open, which sweeps last; motion blur wants it. Finite, 0 or more: at
    /// 0 nothing that sweeps has a past.
    float shutter = 0.5f;

    /// @throws Error for a size of no pixels
    template <class... Ps>
    explicit Frame(Extent size_, Ps const&...)
        : detail::Slot<Cs, ImageOf<Storage, Cs>>{ImageOf<Storage, Cs>(divided(checked(size_), Cs::fraction))}..., size(size_) {}

    template <ChannelTag C> auto& operator[](C) {
        static_assert(channels::template has<C>, "this frame has no such channel: construct it with a pipeline that reads the channel");
        return detail::slot<C>(*this);
    }
    template <ChannelTag C> auto const& operator[](C) const {
        static_assert(channels::template has<C>, "this frame has no such channel: construct it with a pipeline that reads the channel");
        return detail::slot<C>(*this);
    }

    template <class... Ds> [[nodiscard]] auto views(Channels<Ds...>) const {
        return Views<Storage, Channels<Ds...>>{{(*this)[Ds{}].view()}...};
    }

private:
    static Extent checked(Extent size) {
        if (size.width > 0 && size.height > 0) return size;
        throw Error("frame size", to_string(size), "give a width and a height of at least one pixel");
    }
};

namespace detail {
template <class P> struct FrameChannels { using type = reads_of<P>; };
template <class... Ps> using frame_channels = union_of<typename FrameChannels<Ps>::type...>;

template <class... Ps> struct FrameStorage { using type = Planar<>; };
template <class P, class... Ps> struct FrameStorage<P, Ps...> { using type = typename FrameStorage<Ps...>::type; };
template <ImageStorage P, class... Ps> struct FrameStorage<P, Ps...> { using type = P; };
} // namespace detail

template <class... Ps> Frame(Extent, Ps const&...) -> Frame<detail::frame_channels<Ps...>, typename detail::FrameStorage<Ps...>::type>;

} // namespace quell
