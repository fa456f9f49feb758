#pragma once

#include "files.hpp"

#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfTiledOutputFile.h>

// Files as other programs write them: with windows, tiles, parts and sampling that quell itself never writes.
namespace quell::tests {

inline Imath::Box2i box(int x0, int y0, int x1, int y1) { return {{x0, y0}, {x1, y1}}; }
inline std::size_t pixels_of(Imath::Box2i const& b) {
    return static_cast<std::size_t>(b.max.x - b.min.x + 1) * static_cast<std::size_t>(b.max.y - b.min.y + 1);
}

/// The value of a foreign file's channel at a pixel, in the file's own coordinates.
inline float foreign_value(int x, int y) { return static_cast<float>(x) * 100.f + static_cast<float>(y); }

inline std::vector<float> foreign_values(Imath::Box2i const& data) {
    std::vector<float> values;
    for (int y = data.min.y; y <= data.max.y; ++y)
        for (int x = data.min.x; x <= data.max.x; ++x) values.push_back(foreign_value(x, y));
    return values;
}

inline Imf::Header foreign_header(Imath::Box2i const& display, Imath::Box2i const& data, std::vector<std::string> const& channels) {
    Imf::Header header(display, data);
    header.compression() = Imf::PIZ_COMPRESSION;
    for (auto const& name : channels) header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    return header;
}
inline Imf::FrameBuffer buffer_of(std::vector<std::string> const& channels, std::vector<float> const& values, Imath::Box2i const& data) {
    Imf::FrameBuffer buffer;
    for (auto const& name : channels) buffer.insert(name, Imf::Slice::Make(Imf::FLOAT, values.data(), data));
    return buffer;
}

/// One part of scan lines.
inline void write_scan_lines(std::filesystem::path const& path, Imath::Box2i const& display, Imath::Box2i const& data,
                             std::vector<std::string> const& channels) {
    auto const values = foreign_values(data);
    Imf::OutputFile file(path.string().c_str(), foreign_header(display, data, channels));
    file.setFrameBuffer(buffer_of(channels, values, data));
    file.writePixels(data.max.y - data.min.y + 1);
}

/// One part of 16x16 tiles.
inline void write_tiles(std::filesystem::path const& path, Imath::Box2i const& data, std::vector<std::string> const& channels) {
    auto const values = foreign_values(data);
    auto header = foreign_header(data, data, channels);
    header.setTileDescription({16, 16, Imf::ONE_LEVEL});
    Imf::TiledOutputFile file(path.string().c_str(), header);
    file.setFrameBuffer(buffer_of(channels, values, data));
    file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
}

struct ForeignPart {
    std::string name;
    Imath::Box2i data;
    std::vector<std::string> channels;
};
inline void write_parts(std::filesystem::path const& path, Imath::Box2i const& display, std::vector<ForeignPart> const& parts) {
    std::vector<Imf::Header> headers;
    for (auto const& part : parts) {
        headers.push_back(foreign_header(display, part.data, part.channels));
        headers.back().setName(part.name);
        headers.back().setType(Imf::SCANLINEIMAGE);
    }
    Imf::MultiPartOutputFile file(path.string().c_str(), headers.data(), static_cast<int>(headers.size()));
    for (int i = 0; auto const& part : parts) {
        auto const values = foreign_values(part.data);
        Imf::OutputPart out(file, i++);
        out.setFrameBuffer(buffer_of(part.channels, values, part.data));
        out.writePixels(part.data.max.y - part.data.min.y + 1);
    }
}

/// Luminance at full resolution, colour differences at half.
inline void write_sub_sampled(std::filesystem::path const& path, int width, int height) {
    Imf::Header header(width, height);
    header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
    header.channels().insert("RY", Imf::Channel(Imf::FLOAT, 2, 2));
    std::vector<float> const values(static_cast<std::size_t>(width * height), 1.f);
    Imf::OutputFile file(path.string().c_str(), header);
    Imf::FrameBuffer buffer;
    buffer.insert("Y", Imf::Slice::Make(Imf::FLOAT, values.data(), header.dataWindow()));
    buffer.insert("RY", Imf::Slice::Make(Imf::FLOAT, values.data(), header.dataWindow(), 0, 0, 2, 2));
    file.setFrameBuffer(buffer);
    file.writePixels(height);
}

} // namespace quell::tests
