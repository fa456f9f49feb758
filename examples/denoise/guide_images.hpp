#pragma once

#include <denoise/layout_changes.hpp>

#include <quell/io/frame_image.hpp>

namespace quell::examples {

/// Fills guides of a frame from an image. @throws Error as io::load_channels() does
template <class Some, class Set, class Storage>
void load_guides(Some some, Frame<Set, Storage>& frame, io::ExrImage const& image, io::ChannelNames const& names) {
    for_each_channel(some, [](auto channel) { LayoutChanges::add_guide(channel.name); });
    io::load_channels(some, frame, image, names);
}

} // namespace quell::examples
