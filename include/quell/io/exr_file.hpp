#pragma once

#include <quell/io/exr/exr_attributes.hpp>
#include <quell/io/exr/exr_errors.hpp>
#include <quell/io/exr_listing.hpp>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfTileDescription.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>

namespace quell::inline QUELL_INSTRUCTION_SET::io {

/// An EXR file whose header has been read; its channels are read on demand. Supports single and multiple parts, scan lines and tiles (the
/// largest level), and any data window. Deep parts are ignored.
class ExrFile : public ExrListing {
public:
    /// Opens a file and reads its header.
    /// @throws Error naming the file if it is missing, no EXR file, truncated, or of an implausible size
    explicit ExrFile(std::filesystem::path const& path);

    /// Reads these channels, each once.
    /// @throws Error naming the file and the channel
    [[nodiscard]] ExrImage read(std::span<std::string const> names) const;
    /// Reads all channels.
    /// @throws Error naming the file and the channel
    [[nodiscard]] ExrImage read() const;

private:
    std::unique_ptr<Imf::MultiPartInputFile> file;
    Imath::Box2i display;

    void read_header();
    void list_part(int part);
};

/// Reads a whole file.
/// @throws Error as ExrFile does
[[nodiscard]] inline ExrImage read_exr(std::filesystem::path const& path) { return ExrFile(path).read(); }

namespace detail {

/// A larger picture means a broken header.
inline constexpr std::int64_t max_pixels = std::int64_t(1) << 28;

inline SampleType sample_type(Imf::PixelType type) {
    if (type == Imf::HALF) return SampleType::half;
    return type == Imf::UINT ? SampleType::uint32 : SampleType::float32;
}

/// Width and height in 64 bits, as a broken header may hold any corners.
inline std::pair<std::int64_t, std::int64_t> extent_of(Imath::Box2i const& box) {
    return {std::int64_t(box.max.x) - box.min.x + 1, std::int64_t(box.max.y) - box.min.y + 1};
}
inline void check_window(std::string const& file, std::string const& which, Imath::Box2i const& box) {
    auto const [width, height] = extent_of(box);
    if (width > 0 && height > 0 && width <= max_pixels && height <= max_pixels && width * height <= max_pixels) return;
    throw Error(file, "its " + which + " window is " + std::to_string(width) + "x" + std::to_string(height) + " pixels",
                "write it again, with at least one pixel and at most 2^28");
}

/// A channel while it is read: the data window's pixels in the file's type, but half as float.
struct Incoming {
    ExrChannel const* channel;
    std::vector<float> numbers;
    std::vector<std::uint32_t> ids;

    Incoming(ExrChannel const& c, std::size_t pixels) : channel(&c) {
        if (c.type == SampleType::uint32)
            ids.resize(pixels);
        else
            numbers.resize(pixels);
    }
    [[nodiscard]] Imf::Slice slice(Imath::Box2i const& window) const {
        if (channel->type == SampleType::uint32) return Imf::Slice::Make(Imf::UINT, ids.data(), window);
        return Imf::Slice::Make(Imf::FLOAT, numbers.data(), window);
    }
    /// Converts ids to floats; returns whether they are exact.
    bool as_floats() {
        bool exact = true;
        for (auto const id : ids) {
            numbers.push_back(static_cast<float>(id));
            exact = exact && static_cast<std::int64_t>(numbers.back()) == static_cast<std::int64_t>(id);
        }
        return exact;
    }
};

/// Data window clipped to the display window, in the display window's pixels.
inline Region inside(Imath::Box2i const& data, Imath::Box2i const& display) {
    auto const clip = [](int a, int from, int to) { return static_cast<int>(std::clamp<std::int64_t>(std::int64_t(a) - from, 0, to)); };
    int const width = display.max.x - display.min.x + 1, height = display.max.y - display.min.y + 1;
    return {clip(data.min.x, display.min.x, width), clip(data.min.y, display.min.y, height), clip(data.max.x, display.min.x - 1, width),
            clip(data.max.y, display.min.y - 1, height)};
}

/// Copies what was read to its place in the display window.
inline Plane placed(Incoming&& in, Imath::Box2i const& data, Imath::Box2i const& display) {
    Plane plane{.name = in.channel->name,
                .type = in.channel->type,
                .values = {},
                .exact = in.as_floats(),
                .with_part = in.channel->part_name + "." + in.channel->in_part};
    if (data == display) {
        plane.values = std::move(in.numbers);
        return plane;
    }
    auto const stored = plane.stored.emplace(inside(data, display));
    auto const [width, height] = extent_of(display);
    auto const data_width = extent_of(data).first;
    plane.values.resize(static_cast<std::size_t>(width * height));
    for (int y = stored.y0; y < stored.y1; ++y) {
        auto const row = std::int64_t(y) + display.min.y - data.min.y, column = std::int64_t(stored.x0) + display.min.x - data.min.x;
        std::copy_n(in.numbers.begin() + (row * data_width + column), std::max(stored.x1 - stored.x0, 0),
                    plane.values.begin() + (y * width + stored.x0));
    }
    return plane;
}

/// Few damaged bytes in a header can ask for more memory than there is.
/// @param unasked bytes that any file may unpack to
inline void check_memory(std::string const& file, std::size_t channels, std::pair<std::int64_t, std::int64_t> extent, double unasked) {
    auto const claimed = static_cast<double>(extent.first) * static_cast<double>(extent.second) * 4. * static_cast<double>(channels);
    std::error_code none;
    auto const present = static_cast<double>(std::filesystem::file_size(file, none));
    // No noisy picture packs to 1/4000.
    if (claimed > unasked && claimed > 4000. * present)
        throw Error(file, "it claims to unpack to " + std::to_string(static_cast<long long>(claimed / 1e6)) + " MB", "write it again");
}

/// The OpenEXR library takes memory for a whole tile of all channels, however little of it lies in the picture.
inline void check_tiles(std::string const& file, Imf::Header const& header) {
    if (!header.hasTileDescription()) return;
    auto const& tiles = header.tileDescription();
    std::size_t channels = 0;
    for (auto i = header.channels().begin(); i != header.channels().end(); ++i) ++channels;
    check_memory(file, channels, {tiles.xSize, tiles.ySize}, 4e8);
}

/// Adds channels of a part to an image of a canvas: what of the part's data window lies in it.
inline void read_part(Imf::MultiPartInputFile& file, std::string const& name, int part, std::vector<ExrChannel const*> const& wanted,
                      Imath::Box2i const& canvas, ExrImage& image) {
    auto const window = file.header(part).dataWindow();
    check_memory(name, wanted.size(), extent_of(window), 1e8);
    check_memory(name, wanted.size(), extent_of(canvas), 1e9); // most of it lies outside a region that was rendered alone
    auto const [width, height] = extent_of(window);
    std::vector<Incoming> incoming;
    naming_file(name, "its pixels can't be read, it is truncated or damaged", [&, w = width, h = height] {
        Imf::FrameBuffer buffer;
        incoming.reserve(wanted.size());
        for (auto const* const channel : wanted) {
            incoming.emplace_back(*channel, static_cast<std::size_t>(w * h));
            buffer.insert(channel->in_part, incoming.back().slice(window));
        }
        Imf::InputPart input(file, part);
        input.setFrameBuffer(buffer);
        input.readPixels(window.min.y, window.max.y);
    });
    for (auto& each : incoming) image.planes.push_back(placed(std::move(each), window, canvas));
}
} // namespace detail

inline ExrFile::ExrFile(std::filesystem::path const& path) {
    name = path.string();
    detail::check_is_exr(path);
    detail::naming_file(name, "its header can't be read", [&] {
        file = std::make_unique<Imf::MultiPartInputFile>(name.c_str(), 0);
        read_header();
    });
}

inline void ExrFile::read_header() {
    display = file->header(0).displayWindow();
    detail::check_window(name, "display", display);
    size = {display.max.x - display.min.x + 1, display.max.y - display.min.y + 1};
    for (int part = 0; part < file->parts(); ++part) list_part(part);
    if (channels.empty()) throw Error(name, "it has no flat channels", "write scan lines or tiles rather than deep data");
}

inline void ExrFile::list_part(int part) {
    auto const& header = file->header(part);
    detail::copy_attributes(header, attributes);
    if (eyes.empty() && Imf::hasMultiView(header)) eyes = Imf::multiView(header);
    if (header.hasType() && Imf::isDeepData(header.type())) return;
    if (!file->partComplete(part)) throw Error(name, "it is truncated: rows of pixels are missing", "render or copy it again");
    detail::check_window(name, "data", header.dataWindow());
    detail::check_tiles(name, header);
    auto const part_name = header.hasName() ? header.name() : std::to_string(part);
    for (auto i = header.channels().begin(); i != header.channels().end(); ++i) {
        bool const taken = std::ranges::any_of(channels, [&](auto const& c) { return c.name == i.name(); });
        channels.push_back({taken ? part_name + "." + i.name() : i.name(), i.name(), detail::sample_type(i.channel().type), part, part_name,
                            i.channel().xSampling, i.channel().ySampling, header.hasView() ? header.view() : std::string()});
    }
}

inline ExrImage ExrFile::read(std::span<std::string const> names) const {
    std::map<int, std::vector<ExrChannel const*>> wanted;
    for (auto const& each : names) {
        auto const* const channel = find(each);
        if (!channel) detail::throw_missing(name, each, channels);
        if (channel->x_sampling != 1 || channel->y_sampling != 1)
            throw Error(name + " channel '" + each + "'",
                        "it is sub-sampled " + std::to_string(channel->x_sampling) + "x" + std::to_string(channel->y_sampling),
                        "write it at full resolution");
        auto& of_part = wanted[channel->part];
        if (std::ranges::find(of_part, channel) == of_part.end()) of_part.push_back(channel);
    }
    ExrImage image{name, size, {}, attributes};
    for (auto const& [part, of_part] : wanted) detail::read_part(*file, name, part, of_part, display, image);
    return image;
}

inline ExrImage ExrFile::read() const {
    std::vector<std::string> names;
    for (auto const& channel : channels) names.push_back(channel.name);
    return read(names);
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::io
