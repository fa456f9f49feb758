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

std::string encoded(std::string const& file, std::deque<Part> const& parts) {
    io::detail::MemoryStream stream(file);
    std::vector<Imf::Header> headers;
    for (auto const& part : parts) headers.push_back(part.header);
    {
        Imf::MultiPartOutputFile output(stream, headers.data(), static_cast<int>(headers.size()));
        for (int i = 0; auto const& part : parts) {
            Imf::OutputPart to(output, i++);
            to.setFrameBuffer(part.buffer());
            to.writePixels(part.header.dataWindow().max.y - part.header.dataWindow().min.y + 1);
        }
    }
    return stream.contents();
}

/// Whether packing has made light of a part infinite.
bool is_harmed(Part const& part, Imf::MultiPartInputFile& packed, int number) {
    auto const window = part.header.dataWindow();
    std::deque<std::vector<float>> read;
    Imf::FrameBuffer buffer;
    for (auto const& plane : part.planes)
        buffer.insert(plane.name, Imf::Slice::Make(Imf::FLOAT, read.emplace_back(plane.values.size()).data(), window));
    Imf::InputPart input(packed, number);
    input.setFrameBuffer(buffer);
    input.readPixels(window.min.y, window.max.y);
    for (std::size_t i = 0; i < read.size(); ++i)
        if (io::detail::made_infinite(part.planes[i].values, read[i])) return true;
    return false;
}

/// Makes parts lossless that packing harms. Returns their names.
std::vector<std::string> keep_finite(std::string const& file, std::string const& bytes, std::deque<Part>& parts) {
    std::vector<std::string> names;
    io::detail::MemoryInput input(file, bytes);
    Imf::MultiPartInputFile packed(input);
    for (int number = 0; auto& part : parts) {
        if (is_harmed(part, packed, number)) {
            part.header.compression() = Imf::ZIP_COMPRESSION;
            names.push_back(part.header.hasName() ? part.header.name() : std::to_string(number));
        }
        ++number;
    }
    return names;
}

} // namespace

std::vector<std::string> write_upsampled(std::filesystem::path const& path, io::ExrOriginal const& original,
                                         io::ExrChanges const& changes) {
    auto const file = path.string();
    std::vector<std::string> lossless;
    std::string bytes;
    io::detail::naming_file<Failure>(file, "it can't be encoded", [&] {
        auto parts = parts_of(file, original, changes);
        bytes = encoded(file, parts);
        lossless = keep_finite(file, bytes, parts);
        if (!lossless.empty()) bytes = encoded(file, parts);
    });
    io::replace_file(path, bytes);
    return lossless;
}

} // namespace quell::examples
