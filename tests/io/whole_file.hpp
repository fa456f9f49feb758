#pragma once

#include "foreign.hpp"

#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMatrixAttribute.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfOpaqueAttribute.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfStringVectorAttribute.h>
#include <OpenEXR/ImfTiledOutputPart.h>

#include <map>

// Files with everything that a renderer may put into them, and all that is in a file, by the library's own interface.
namespace quell::tests {

/// A channel of a part: f(x, y) in the file's own coordinates.
struct WholeChannel {
    std::string name;
    Imf::PixelType type = Imf::HALF;
    std::function<float(int, int)> f;
};
struct WholePart {
    std::string name;
    Imath::Box2i data;
    std::vector<WholeChannel> channels;
    bool tiled = false;
    Imf::Compression compression = Imf::ZIP_COMPRESSION;
    std::string view = {};
    std::vector<std::string> eyes = {}; ///< the attribute multiView
};

/// Attributes of several types, one of which no library knows.
inline void add_attributes(Imf::Header& header) {
    header.insert("owner", Imf::StringAttribute("someone"));
    header.insert("worldToCamera", Imf::M44fAttribute(Imath::M44f(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16)));
    header.insert("views", Imf::StringVectorAttribute({"left", "right"}));
    header.insert("studio:shot", Imf::OpaqueAttribute("studioType"));
    header.insert("cryptomatte/f834d0a/name", Imf::StringAttribute("crypto"));
    header.insert("cryptomatte/f834d0a/manifest", Imf::StringAttribute(R"({"box":"3e8f1c2a"})"));
    header.pixelAspectRatio() = 1.5f;
    header.screenWindowWidth() = 2.f;
}

inline Imf::Header header_of(Imath::Box2i const& display, WholePart const& part) {
    Imf::Header header(display, part.data);
    header.compression() = part.compression;
    header.lineOrder() = Imf::INCREASING_Y;
    if (!part.name.empty()) header.setName(part.name);
    if (!part.view.empty()) header.setView(part.view);
    if (!part.eyes.empty()) Imf::addMultiView(header, part.eyes);
    header.setType(part.tiled ? Imf::TILEDIMAGE : Imf::SCANLINEIMAGE);
    if (part.tiled) header.setTileDescription({16, 16, Imf::ONE_LEVEL});
    for (auto const& channel : part.channels) header.channels().insert(channel.name, Imf::Channel(channel.type));
    add_attributes(header);
    return header;
}

/// Writes parts, one or more, with these channels.
inline void write_whole(std::filesystem::path const& path, Imath::Box2i const& display, std::vector<WholePart> const& parts) {
    std::vector<Imf::Header> headers;
    for (auto const& part : parts) headers.push_back(header_of(display, part));
    Imf::MultiPartOutputFile file(path.string().c_str(), headers.data(), static_cast<int>(headers.size()));
    for (int i = 0; auto const& part : parts) {
        std::deque<std::vector<std::uint32_t>> words; // one for each number, whichever format: slices stride over them
        Imf::FrameBuffer buffer;
        for (auto const& channel : part.channels) {
            auto& column = words.emplace_back();
            for (int y = part.data.min.y; y <= part.data.max.y; ++y)
                for (int x = part.data.min.x; x <= part.data.max.x; ++x) {
                    auto const value = channel.f(x, y);
                    column.push_back(channel.type == Imf::UINT    ? static_cast<std::uint32_t>(value)
                                     : channel.type == Imf::FLOAT ? std::bit_cast<std::uint32_t>(value)
                                                                  : half_from_float(value));
                }
            buffer.insert(channel.name, Imf::Slice::Make(channel.type, column.data(), part.data, sizeof(std::uint32_t)));
        }
        if (part.tiled) {
            Imf::TiledOutputPart out(file, i++);
            out.setFrameBuffer(buffer);
            out.writeTiles(0, out.numXTiles() - 1, 0, out.numYTiles() - 1);
        } else {
            Imf::OutputPart out(file, i++);
            out.setFrameBuffer(buffer);
            out.writePixels(part.data.max.y - part.data.min.y + 1);
        }
    }
}

/// All that is in a file, as bytes: attributes as "part name" and channels as "part name.of.channel format".
struct Whole {
    std::map<std::string, std::string> attributes, channels;
    std::vector<std::string> part_names;
};
inline Whole whole_of(std::filesystem::path const& path) {
    Whole whole;
    Imf::MultiPartInputFile file(path.string().c_str());
    for (int part = 0; part < file.parts(); ++part) {
        auto const& header = file.header(part);
        auto const prefix = std::to_string(part) + " ";
        whole.part_names.push_back(header.hasName() ? header.name() : "");
        for (auto i = header.begin(); i != header.end(); ++i) {
            if (std::string_view(i.name()) == "channels" || std::string_view(i.name()) == "chunkCount") continue;
            io::detail::MemoryStream text("an attribute");
            i.attribute().writeValueTo(text, 2);
            whole.attributes[prefix + i.name()] = i.attribute().typeName() + (" " + text.contents());
        }
        auto const window = header.dataWindow();
        Imf::FrameBuffer buffer;
        std::deque<std::string> bytes;
        std::vector<std::string> names;
        for (auto i = header.channels().begin(); i != header.channels().end(); ++i) {
            auto const type = i.channel().type;
            auto& column = bytes.emplace_back(pixels_of(window) * (type == Imf::HALF ? 2 : 4), '\0');
            buffer.insert(i.name(), Imf::Slice::Make(type, column.data(), window));
            names.push_back(prefix + i.name() + (type == Imf::HALF ? " half" : type == Imf::FLOAT ? " float" : " uint"));
        }
        Imf::InputPart input(file, part);
        input.setFrameBuffer(buffer);
        input.readPixels(window.min.y, window.max.y);
        for (std::size_t i = 0; i < names.size(); ++i) whole.channels[names[i]] = bytes[i];
    }
    return whole;
}

/// The channels whose bytes differ, or that one of both lacks.
inline std::vector<std::string> different(Whole const& a, Whole const& b) {
    std::vector<std::string> names;
    for (auto const& [name, bytes] : a.channels)
        if (!b.channels.contains(name) || b.channels.at(name) != bytes) names.push_back(name);
    for (auto const& [name, bytes] : b.channels)
        if (!a.channels.contains(name)) names.push_back(name);
    return names;
}

inline std::vector<std::pair<std::string, Imf::Compression>> const& all_compressions() {
    static std::vector<std::pair<std::string, Imf::Compression>> const all{
        {"none", Imf::NO_COMPRESSION},  {"rle", Imf::RLE_COMPRESSION},   {"zips", Imf::ZIPS_COMPRESSION},
        {"zip", Imf::ZIP_COMPRESSION},  {"piz", Imf::PIZ_COMPRESSION},   {"pxr24", Imf::PXR24_COMPRESSION},
        {"b44", Imf::B44_COMPRESSION},  {"b44a", Imf::B44A_COMPRESSION}, {"dwaa", Imf::DWAA_COMPRESSION},
        {"dwab", Imf::DWAB_COMPRESSION}};
    return all;
}

} // namespace quell::tests
