#pragma once

#include <quell/frame/frame.hpp>
#include <quell/image/held_view.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// The storage of a frame that shows the host's images, but for some channels, which it shows images of quell's own of.
/// @tparam FrameStorage of the host's frame
/// @tparam Storage      of quell's own images
/// @tparam Own          those channels
template <class FrameStorage, class Storage, class Own> struct WithStandIns {
    using Exact = WithStandIns;
    using Others = FrameStorage;
    using Memory = MemoryOf<FrameStorage>;
    static constexpr bool owns_memory = false;
    static constexpr auto name = "with stand-ins";
    template <int N> using Image = typename FrameStorage::template Image<N>;
    template <ChannelTag C> using ImageOf = HeldView<ViewOf<std::conditional_t<Own::template has<C>, Storage, FrameStorage>, C>>;
};

/// A frame in which other images stand for some channels.
/// @tparam Set     channels that it has
/// @tparam Own     those of which others stand in
/// @tparam Storage of these
/// @param frame    the host's
/// @param stand_in stand_in(channel): the view of one
template <class Set, class Own, class Storage, class HostSet, class FrameStorage>
auto with_stand_ins(Frame<HostSet, FrameStorage> const& frame, auto const& stand_in) {
    Frame<Set, WithStandIns<FrameStorage, Storage, Own>> seen(frame.size);
    seen.camera = frame.camera, seen.number = frame.number, seen.shutter = frame.shutter;
    for_each_channel(Set{}, [&]<class C>(C c) {
        if constexpr (Own::template has<C>)
            seen[c] = HeldView(ViewOf<Storage, C>(stand_in(c)));
        else
            seen[c] = HeldView(frame[c].view());
    });
    return seen;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
