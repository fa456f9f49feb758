#include <denoise/upsampled_file.hpp>

#include <cmath>
#include <deque>
#include <string_view>

namespace quell::examples {

namespace {

int scaled(int corner, int from, int to) {
    return static_cast<int>(std::lround(static_cast<double>(corner) * static_cast<double>(to) / static_cast<double>(from)));
}

Imf::Header header_of(Imf::Header const& original, Extent from, Extent to) {
    auto header = original;
    auto const corner = original.displayWindow().min;
    Imath::V2i const at{scaled(corner.x, from.width, to.width), scaled(corner.y, from.height, to.height)};
    header.displayWindow() = header.dataWindow() = {at, at + Imath::V2i(to.width - 1, to.height - 1)};
    header.channels() = Imf::ChannelList();
    header.lineOrder() = Imf::INCREASING_Y;
    std::vector<std::string> gone{"tiles", "chunkCount", "preview"};
    for (auto i = original.begin(); i != original.end(); ++i)
        if (std::string_view(i.name()).starts_with("cryptomatte/")) gone.emplace_back(i.name());
    for (auto const& name : gone) header.erase(name);
    header.setType(Imf::SCANLINEIMAGE);
    for (auto const* const jitter : {"quell:jitter", "quell:jitter_previous"})
        if (original.findTypedAttribute<Imf::V2fAttribute>(jitter)) header.insert(jitter, Imf::V2fAttribute({0.f, 0.f}));
    return header;
}

/// A part of the file: its header, and its numbers as they are stored.
struct Part {
    Imf::Header header;
    std::deque<io::Plane> planes = {};
    std::deque<io::detail::Outgoing> numbers = {};

    void add(std::string const& file, io::NewNumbers const& of_channel, Imf::Header const& original) {
        auto const* const known = original.channels().findChannel(of_channel.channel);
        auto const is_half = known ? known->type == Imf::HALF : of_channel.type == io::SampleType::half;
        auto const type = is_half ? io::SampleType::half : io::SampleType::float32;
        header.channels().insert(of_channel.channel, Imf::Channel(io::detail::pixel_type(type)));
        planes.push_back({.name = of_channel.channel, .type = type, .values = of_channel.values});
        numbers.emplace_back(file, planes.back());
    }
    [[nodiscard]] Imf::FrameBuffer buffer() const {
        Imf::FrameBuffer slices;
        for (std::size_t i = 0; i < planes.size(); ++i)
            slices.insert(planes[i].name, Imf::Slice::Make(io::detail::pixel_type(planes[i].type), numbers[i].data, header.dataWindow()));
        return slices;
    }
};

std::deque<Part> parts_of(std::string const& file, io::ExrOriginal const& original, io::ExrChanges const& changes) {
    std::deque<Part> parts;
    for (int number = 0; number < original.parts(); ++number) {
        auto const& header = original.header(number);
        Part part{header_of(header, original.listed.size, io::detail::size_of(changes.canvas))};
        for (auto const& each : changes.numbers)
            if (each.part == number) part.add(file, each, header);
        if (!part.planes.empty()) parts.push_back(std::move(part));
    }
    return parts;
}

} // namespace

void write_upsampled(std::filesystem::path const& path, io::ExrOriginal const& original, io::ExrChanges const& changes) {
    auto const file = path.string();
    io::detail::MemoryStream stream(file);
    io::detail::naming_file<Failure>(file, "it can't be encoded", [&] {
        auto const parts = parts_of(file, original, changes);
        std::vector<Imf::Header> headers;
        for (auto const& part : parts) headers.push_back(part.header);
        Imf::MultiPartOutputFile output(stream, headers.data(), static_cast<int>(headers.size()));
        for (int i = 0; auto const& part : parts) {
            Imf::OutputPart to(output, i++);
            to.setFrameBuffer(part.buffer());
            to.writePixels(part.header.dataWindow().max.y - part.header.dataWindow().min.y + 1);
        }
    });
    io::replace_file(path, stream.contents());
}

} // namespace quell::examples
