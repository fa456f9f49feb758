#pragma once

#include <quell/io/exr/exr_original.hpp>
#include <quell/io/exr/packing_loss.hpp>
#include <quell/io/write_exr.hpp>

#include <OpenEXR/ImfDeepScanLineInputPart.h>
#include <OpenEXR/ImfDeepScanLineOutputPart.h>
#include <OpenEXR/ImfDeepTiledInputPart.h>
#include <OpenEXR/ImfDeepTiledOutputPart.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfTiledInputPart.h>
#include <OpenEXR/ImfTiledOutputPart.h>

#include <cstring>
#include <functional>

namespace quell::inline QUELL_INSTRUCTION_SET::io {

/// Numbers for one channel of a copy.
struct NewNumbers {
    int part = 0;                       ///< index of the part
    std::string channel;                ///< name within the part
    SampleType type = SampleType::half; ///< of a channel that the part lacks; one that it has keeps its own
    std::vector<float> values;          ///< row by row of the canvas
};

namespace detail {

/// A file in memory, to read from. The library seeks and reads; `bytes` must outlive it.
class MemoryInput : public Imf::IStream {
    std::string const& bytes;
    std::size_t at = 0;

public:
    MemoryInput(std::string const& name, std::string const& contents) : Imf::IStream(name.c_str()), bytes(contents) {}
    bool read(char into[], int count) override {
        auto const length = static_cast<std::size_t>(count);
        if (length > bytes.size() - std::min(at, bytes.size())) throw std::runtime_error("unexpected end of file");
        std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(at), length, into);
        at += length;
        return at < bytes.size();
    }
    std::uint64_t tellg() override { return at; }
    void seekg(std::uint64_t position) override { at = position; }
};

/// A channel's numbers in the file's own format: not a bit changes on their way.
struct UnpackedChannel {
    std::vector<char> bytes;
    Imf::Slice slice;

    UnpackedChannel(Imf::Channel const& channel, Imath::Box2i const& window)
        : bytes(static_cast<std::size_t>(extent_of(window).first * extent_of(window).second) * (channel.type == Imf::HALF ? 2 : 4)),
          slice(Imf::Slice::Make(channel.type, bytes.data(), window, 0, 0, channel.xSampling, channel.ySampling)) {}
};

/// One part of a copy.
class CopiedPart {
    std::vector<NewNumbers const*> numbers;
    std::vector<std::string> guides; ///< channels that are data, whatever they are called
    bool dropped = false;

public:
    int number;         ///< of the original's part
    Imf::Header header; ///< of the copy's

    CopiedPart(int original, Imf::Header const& h) : number(original), header(h) {}

    void keep_channels(auto const& keeps) {
        Imf::ChannelList kept;
        auto const part = header.hasName() ? header.name() : std::string();
        for (auto i = header.channels().begin(); i != header.channels().end(); ++i)
            if (keeps(part, i.name()))
                kept.insert(i.name(), i.channel());
            else
                dropped = true;
        // Samples of a deep pixel belong together.
        if (!is_deep(header) || kept.begin() == kept.end()) header.channels() = kept;
    }
    void add(NewNumbers const& of_channel) {
        numbers.push_back(&of_channel);
        if (!header.channels().findChannel(of_channel.channel))
            header.channels().insert(of_channel.channel, Imf::Channel(pixel_type(of_channel.type)));
    }
    void add_guide(std::string const& channel) { guides.push_back(channel); }

    /// Whether it has to be packed again.
    [[nodiscard]] bool is_touched() const { return !is_deep(header) && (dropped || !numbers.empty()); }
    [[nodiscard]] bool is_lossy() const {
        auto const c = header.compression();
        return c == Imf::PXR24_COMPRESSION || c == Imf::B44_COMPRESSION || c == Imf::B44A_COMPRESSION || c == Imf::DWAA_COMPRESSION ||
               c == Imf::DWAB_COMPRESSION;
    }
    /// Whether packing has changed data, or made light infinite.
    [[nodiscard]] bool is_harmed(ExrOriginal const& original, Region const& canvas, Imf::MultiPartInputFile& copy, int part) const;
    /// @param from the original's file, opened anew: the library must not open a part as two kinds of it
    void write(ExrOriginal const& original, Imf::MultiPartInputFile& from, Region const& canvas, Imf::MultiPartOutputFile& output,
               int part) const;

private:
    [[nodiscard]] bool is_tiled() const { return header.hasType() ? header.type() == Imf::TILEDIMAGE : header.hasTileDescription(); }
    [[nodiscard]] bool is_new(std::string const& channel) const {
        return std::ranges::any_of(numbers, [&](auto const* each) { return each->channel == channel; });
    }
    [[nodiscard]] bool is_data(std::string const& channel, Imf::PixelType type) const {
        return std::ranges::find(guides, channel) != guides.end() || detail::is_data(header, channel, type);
    }
    using Wanted = std::function<bool(std::string const& channel, Imf::PixelType type)>;
    /// Channels as a file has them, by name.
    [[nodiscard]] std::map<std::string, UnpackedChannel> unpacked_channels(Imf::MultiPartInputFile& file, int part,
                                                                           Wanted const& is_wanted) const;
    /// Numbers of light as floats, by the channel's name.
    [[nodiscard]] std::map<std::string, std::vector<float>> light_of(Imf::MultiPartInputFile& file, int part, bool with_new) const;
    [[nodiscard]] bool changes_data(ExrOriginal const& original, Imf::MultiPartInputFile& copy, int part) const;
    [[nodiscard]] Plane cropped(NewNumbers const& of_channel, ExrOriginal const& original, Region const& canvas) const;
    void copy_packed(Imf::MultiPartInputFile& from, Imf::MultiPartOutputFile& output, int part) const;
    void write_pixels(Imf::FrameBuffer const& buffer, Imf::MultiPartOutputFile& output, int part) const;
};

inline std::map<std::string, UnpackedChannel> CopiedPart::unpacked_channels(Imf::MultiPartInputFile& file, int part,
                                                                            Wanted const& is_wanted) const {
    std::map<std::string, UnpackedChannel> unpacked;
    Imf::FrameBuffer buffer;
    auto const window = header.dataWindow();
    for (auto i = header.channels().begin(); i != header.channels().end(); ++i) {
        if (!is_wanted(i.name(), i.channel().type)) continue;
        auto const& made = unpacked.emplace(i.name(), UnpackedChannel(i.channel(), window)).first->second;
        buffer.insert(i.name(), made.slice);
    }
    if (unpacked.empty()) return unpacked;
    Imf::InputPart input(file, part);
    input.setFrameBuffer(buffer);
    input.readPixels(window.min.y, window.max.y);
    return unpacked;
}

inline std::map<std::string, std::vector<float>> CopiedPart::light_of(Imf::MultiPartInputFile& file, int part, bool with_new) const {
    std::map<std::string, std::vector<float>> light;
    Imf::FrameBuffer buffer;
    auto const window = header.dataWindow();
    auto const [width, height] = extent_of(window);
    for (auto i = header.channels().begin(); i != header.channels().end(); ++i) {
        auto const& channel = i.channel();
        if (is_data(i.name(), channel.type) || (is_new(i.name()) && !with_new)) continue;
        auto const& read = light.emplace(i.name(), std::vector<float>(static_cast<std::size_t>(width * height))).first->second;
        buffer.insert(i.name(), Imf::Slice::Make(Imf::FLOAT, read.data(), window, 0, 0, channel.xSampling, channel.ySampling));
    }
    if (light.empty()) return light;
    Imf::InputPart input(file, part);
    input.setFrameBuffer(buffer);
    input.readPixels(window.min.y, window.max.y);
    return light;
}

inline bool CopiedPart::changes_data(ExrOriginal const& original, Imf::MultiPartInputFile& copy, int part) const {
    auto const is_wanted = [&](std::string const& channel, Imf::PixelType type) { return !is_new(channel) && is_data(channel, type); };
    auto const before = unpacked_channels(original.library_file(), number, is_wanted), after = unpacked_channels(copy, part, is_wanted);
    return !std::ranges::equal(before, after, [](auto const& a, auto const& b) { return a.second.bytes == b.second.bytes; });
}

inline bool CopiedPart::is_harmed(ExrOriginal const& original, Region const& canvas, Imf::MultiPartInputFile& copy, int part) const {
    if (changes_data(original, copy, part)) return true;
    auto const packed = light_of(copy, part, true);
    auto const is_all_finite = [](auto const& channel) {
        return std::ranges::all_of(channel.second, [](float v) { return is_finite(v); });
    };
    if (std::ranges::all_of(packed, is_all_finite)) return false;
    auto light = light_of(original.library_file(), number, false);
    for (auto const* const each : numbers) light.insert_or_assign(each->channel, cropped(*each, original, canvas).values);
    return std::ranges::any_of(packed, [&](auto const& channel) { return made_infinite(light.at(channel.first), channel.second); });
}

inline Plane CopiedPart::cropped(NewNumbers const& of_channel, ExrOriginal const& original, Region const& canvas) const {
    auto const data = original.data_window(number);
    auto const size = size_of(canvas);
    auto const subject = original.listed.name + " channel '" + of_channel.channel + "'";
    if (static_cast<long long>(of_channel.values.size()) != size.pixels())
        throw Failure(subject, std::to_string(of_channel.values.size()) + " numbers for a canvas of " + to_string(size),
                      "give one per pixel");
    if (data.x0 < canvas.x0 || data.y0 < canvas.y0 || data.x1 > canvas.x1 || data.y1 > canvas.y1)
        throw Failure(subject, "its data window reaches out of the canvas", "make the canvas hold the data window");
    if (auto const* const channel = header.channels().findChannel(of_channel.channel); channel->xSampling != 1 || channel->ySampling != 1)
        throw Error(subject, "it is sub-sampled", "write it at full resolution");
    Plane plane{.name = of_channel.channel, .type = sample_type(header.channels()[of_channel.channel].type), .values = {}};
    for (int y = data.y0; y < data.y1; ++y) {
        auto const row = static_cast<std::ptrdiff_t>(y - canvas.y0) * size.width + (data.x0 - canvas.x0);
        auto const begin = of_channel.values.begin() + row;
        plane.values.insert(plane.values.end(), begin, begin + (data.x1 - data.x0));
    }
    return plane;
}

inline void CopiedPart::copy_packed(Imf::MultiPartInputFile& from, Imf::MultiPartOutputFile& output, int part) const {
    auto const copy = [&](auto&& in, auto&& out) { out.copyPixels(in); };
    auto const type = header.hasType() ? header.type() : std::string();
    if (type == Imf::DEEPSCANLINE)
        copy(Imf::DeepScanLineInputPart(from, number), Imf::DeepScanLineOutputPart(output, part));
    else if (type == Imf::DEEPTILE)
        copy(Imf::DeepTiledInputPart(from, number), Imf::DeepTiledOutputPart(output, part));
    else if (is_tiled())
        copy(Imf::TiledInputPart(from, number), Imf::TiledOutputPart(output, part));
    else
        copy(Imf::InputPart(from, number), Imf::OutputPart(output, part));
}

inline void CopiedPart::write_pixels(Imf::FrameBuffer const& buffer, Imf::MultiPartOutputFile& output, int part) const {
    if (!is_tiled()) {
        Imf::OutputPart out(output, part);
        out.setFrameBuffer(buffer);
        return out.writePixels(static_cast<int>(extent_of(header.dataWindow()).second));
    }
    Imf::TiledOutputPart out(output, part);
    out.setFrameBuffer(buffer);
    out.writeTiles(0, out.numXTiles() - 1, 0, out.numYTiles() - 1);
}

inline void CopiedPart::write(ExrOriginal const& original, Imf::MultiPartInputFile& from, Region const& canvas,
                              Imf::MultiPartOutputFile& output, int part) const {
    if (!is_touched()) return copy_packed(from, output, part);
    if (original.has_levels(number))
        throw Error(original.listed.name, "its tiles have several levels (a mip map or rip map)", "write frames with one level");
    auto const unpacked = unpacked_channels(from, number, [&](std::string const& channel, auto) { return !is_new(channel); });
    Imf::FrameBuffer buffer;
    for (auto const& [name, channel] : unpacked) buffer.insert(name, channel.slice);
    std::deque<Plane> planes; // slices point into these
    std::deque<Outgoing> outgoing;
    for (auto const* const each : numbers) {
        auto const& plane = planes.emplace_back(cropped(*each, original, canvas));
        auto const& packed = outgoing.emplace_back(original.listed.name, plane);
        buffer.insert(each->channel, Imf::Slice::Make(pixel_type(plane.type), packed.data, header.dataWindow()));
    }
    write_pixels(buffer, output, part);
}

} // namespace detail

} // namespace quell::inline QUELL_INSTRUCTION_SET::io
