#pragma once

#include <library/loaded_frame.hpp>

#include <quell/frame/frame.hpp>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace quell::examples {

/// A channel of a file as kernels read it.
struct LoadedChannel {
    quell_library::FileChannel::Memory memory{};
    quell_library::Image image{}; ///< lies there
    Extent size{};

    template <ChannelTag C> [[nodiscard]] ViewOf<Planar<>, C> view(C) const {
        ViewOf<Planar<>, C> view{{}, size};
        for (int c = 0; c < C::components; ++c) view.planes[c] = reinterpret_cast<float*>(image.data + c * image.component_stride);
        return view;
    }
};
using LoadedChannelPointer = std::shared_ptr<LoadedChannel const>;
/// Reads one. @throws Error naming the file and what is wrong with it
[[nodiscard]] LoadedChannelPointer load_channel(std::string_view channel, io::ExrImage const& image, io::ChannelNames const& names);

/// Guides of a frame, each of which is decoded once, whichever signal or stage asks for it first.
class GuideImages {
    std::map<std::string, LoadedChannelPointer> loaded; ///< by the channel and what it is read from

public:
    /// A channel; null where the image has not all of its planes.
    /// @param image the frame
    /// @throws Error naming the file and what is wrong with it
    [[nodiscard]] LoadedChannelPointer get(std::string_view channel, io::ExrImage const& image, io::ChannelNames const& names);
    /// What is read from a channel's planes is read anew: they have changed.
    void forget(std::string_view channel);
};

} // namespace quell::examples
