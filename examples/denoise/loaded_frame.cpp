#include <denoise/loaded_frame.hpp>

#include <library/images_of_frame.hpp>

#include <quell/io/frame_image.hpp>
#include <quell/pipeline/two_sided.hpp>
#include <quell/presets/named.hpp>

#include <algorithm>

namespace quell::examples {

namespace {

using Memory = Planar<>::Image<1>;
template <int N> using PlanesView = Planar<>::Image<N>::View;

/// Planes of N components in padded rows, one after the other.
template <int N> PlanesView<N> planes_in(Memory& memory, Extent size) {
    if (Extent const wanted{size.width, N * (size.height + 1)}; !(memory.size() == wanted)) memory = Memory(wanted);
    return PlanesView<N>::of(memory.view().planes[0] - detail::padding, size);
}

/// A channel, by its name, in files.
struct FileChannel {
    std::string_view name;
    std::vector<std::string> (*planes)(io::ChannelNames const& names);
    quell_library::Image (*load)(Memory& memory, io::ExrImage const& image, io::ChannelNames const& names);
};

template <class P> struct ChannelsRead { using type = decltype(typename P::reads{} | TwoSided::reads{}); };
/// All that presets read.
template <class... Named> auto channels_read(std::tuple<Named...> const&) {
    return union_of<typename ChannelsRead<std::remove_const_t<decltype(Named::usual())>>::type..., Channels<SampleCount, SampleVariance>,
                    Channels<Direct, RadianceAlpha>>{};
}

std::vector<FileChannel> all_channels() {
    std::vector<FileChannel> all;
    for_each_channel(decltype(channels_read(named_presets)){}, [&]<class C>(C) {
        all.push_back({C::name, [](io::ChannelNames const& names) { return io::planes_of(Channels<C>{}, names); },
                       [](Memory& memory, io::ExrImage const& image, io::ChannelNames const& names) {
                           auto const view = planes_in<C::components>(memory, image.size);
                           io::detail::load_channel(C{}, view, image, names);
                           return quell_library::image_of_view(view);
                       }});
    });
    return all;
}

FileChannel const& in_files(ReadChannel const& channel) {
    static auto const all = all_channels();
    auto const found = std::ranges::find(all, channel.name, &FileChannel::name);
    if (found == all.end() || channel.fraction != 1)
        throw Error("channel '" + channel.name + "'", "no file holds it", "choose a preset that does not read it");
    return *found;
}

} // namespace

std::vector<std::string> planes_of(ReadChannel const& channel, io::ChannelNames const& names) { return in_files(channel).planes(names); }

void LoadedFrame::load(std::span<ReadChannel const> channels, io::ExrImage const& image, io::ChannelNames const& names, long long number) {
    images.size = image.size, images.number = number, images.camera = {}, images.shutter = quell_library::FrameImages().shutter;
    images.channels.resize(channels.size()), planes.resize(channels.size());
    for (std::size_t i = 0; i < channels.size(); ++i) {
        auto const& channel = in_files(channels[i]);
        auto const needed = channel.planes(names);
        images.channels[i] = {};
        if (channels[i].optional && !std::ranges::all_of(needed, [&](auto const& plane) { return image.find(plane) != nullptr; })) continue;
        images.channels[i] = channel.load(planes[i], image, names);
    }
    if (auto const camera = io::camera_of(image)) images.camera = *camera;
    if (auto const shutter = io::shutter_of(image, names)) images.shutter = *shutter;
}

} // namespace quell::examples
