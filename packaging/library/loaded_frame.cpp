#include "loaded_frame.hpp"

#include "images_of_frame.hpp"

#include <quell/io/frame_image.hpp>

#include <algorithm>

namespace quell_library {

namespace {

using namespace quell;
using Planes = FileChannel::Memory;
template <int N> using PlanesView = typename Planar<>::template Image<N>::View;

/// Planes of N components in padded rows, one after the other.
template <int N> PlanesView<N> planes_in(Planes& memory, Extent size) {
    if (Extent const wanted{size.width, N * (size.height + 1)}; !(memory.size() == wanted)) memory = Planes(wanted);
    return PlanesView<N>::of(memory.view().planes[0] - quell::detail::padding, size);
}

FileChannel const& in_files(ReadChannel const& channel) {
    auto const* const found = find_file_channel(channel.name);
    if (found == nullptr || channel.fraction != 1)
        throw Error("channel '" + channel.name + "'", "no file holds it", "choose a preset that does not read it");
    return *found;
}

} // namespace

std::vector<FileChannel> const& file_channels() {
    static auto const all = [] {
        std::vector<FileChannel> made;
        for_each_channel(AllChannels{} | Channels<RadianceAlpha>{}, [&]<class C>(C) {
            made.push_back({C::name, C::components, [](io::ChannelNames const& names) { return io::planes_of(Channels<C>{}, names); },
                            [](Planes& memory, io::ExrImage const& image, io::ChannelNames const& names) {
                                auto const view = planes_in<C::components>(memory, image.size);
                                io::detail::load_channel(C{}, view, image, names);
                                return image_of_view(view);
                            }});
        });
        return made;
    }();
    return all;
}

FileChannel const* find_file_channel(std::string_view name) {
    auto const& all = file_channels();
    auto const found = std::ranges::find(all, name, &FileChannel::name);
    return found != all.end() ? &*found : nullptr;
}

std::vector<std::string> planes_of(ReadChannel const& channel, io::ChannelNames const& names) { return in_files(channel).planes(names); }

void LoadedFrame::load(std::span<ReadChannel const> channels, io::ExrImage const& image, io::ChannelNames const& names,
                       std::optional<long long> number) {
    images.size = image.size, images.number = number, images.camera = {}, images.shutter = FrameImages().shutter;
    images.channels.resize(channels.size()), planes.resize(channels.size());
    for (std::size_t i = 0; i < channels.size(); ++i) {
        auto const& channel = in_files(channels[i]);
        auto const needed = channel.planes(names);
        images.channels[i] = {};
        if (channels[i].optional && !image.has_all(needed)) continue;
        images.channels[i] = channel.load(planes[i], image, names);
    }
    if (auto const camera = io::camera_of(image)) images.camera = *camera;
    if (auto const shutter = io::shutter_of(image, names)) images.shutter = *shutter;
}

} // namespace quell_library
