#pragma once

#include <quell/core/half.hpp>
#include <quell/io/exr/exr_attributes.hpp>
#include <quell/io/exr/exr_errors.hpp>
#include <quell/io/exr_image.hpp>
#include <quell/io/replace_file.hpp>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfCompression.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfOutputFile.h>

#include <cstdint>
#include <deque>

namespace quell::inline QUELL_INSTRUCTION_SET::io {

namespace detail {

/// A file in memory, as the library's streams lose errors on closing.
class MemoryStream : public Imf::OStream {
    std::string bytes;
    std::size_t at = 0;

public:
    explicit MemoryStream(std::string const& name) : Imf::OStream(name.c_str()) {}
    void write(char const text[], int count) override {
        auto const length = static_cast<std::size_t>(count);
        if (bytes.size() < at + length) bytes.resize(at + length);
        std::copy_n(text, length, bytes.begin() + static_cast<std::ptrdiff_t>(at));
        at += length;
    }
    std::uint64_t tellp() override { return at; }
    void seekp(std::uint64_t position) override { at = position; }
    [[nodiscard]] std::string const& contents() const { return bytes; }
};

inline Imf::PixelType pixel_type(SampleType type) {
    if (type == SampleType::half) return Imf::HALF;
    return type == SampleType::uint32 ? Imf::UINT : Imf::FLOAT;
}

/// Finite values stay finite; infinities and NaN stay as they are.
inline std::uint16_t stored_half(float value) {
    auto const bits = std::bit_cast<std::uint32_t>(value);
    if ((bits & 0x7fffffffu) == 0x7f800000u) return static_cast<std::uint16_t>(((bits >> 16) & 0x8000u) | 0x7c00u);
    return half_from_float(value);
}

/// A plane's numbers in the file's format.
struct Outgoing {
    std::vector<std::uint16_t> halves;
    std::vector<std::uint32_t> ids;
    void const* data = nullptr;

    Outgoing(std::string const& file, Plane const& plane) : data(plane.values.data()) {
        if (plane.type == SampleType::half) make_halves(plane);
        if (plane.type == SampleType::uint32) make_ids(file, plane);
    }

private:
    void make_halves(Plane const& plane) {
        for (auto const value : plane.values) halves.push_back(stored_half(value));
        data = halves.data();
    }
    void make_ids(std::string const& file, Plane const& plane) {
        for (auto const value : plane.values) {
            // Integers above 2^24 are not all floats. The comparison also rejects NaN.
            bool const whole = value >= 0.f && value <= 16777216.f && value == static_cast<float>(static_cast<std::uint32_t>(value));
            if (!whole)
                throw Failure(file + " channel '" + plane.name + "'", "a value is " + std::to_string(value),
                              "store whole numbers from 0 to 2^24 as uint, others as float");
            ids.push_back(static_cast<std::uint32_t>(value));
        }
        data = ids.data();
    }
};

inline void check_writable(std::string const& file, ExrImage const& image) {
    if (image.size.width <= 0 || image.size.height <= 0) throw Failure(file, "its size is " + to_string(image.size), "give it pixels");
    if (image.planes.empty()) throw Failure(file, "it has no channels", "give it at least one plane");
    for (auto const& plane : image.planes) {
        auto const subject = file + " channel '" + plane.name + "'";
        if (plane.values.size() != image.pixels())
            throw Failure(subject, "it has " + std::to_string(plane.values.size()) + " values in an image of " + to_string(image.size),
                          "give every plane " + std::to_string(image.pixels()));
        if (plane.name.empty() || image.find(plane.name) != &plane)
            throw Failure(subject, "its name is empty or taken", "give each plane a name of its own");
    }
}

inline void encode(Imf::OStream& stream, std::string const& file, ExrImage const& image, Imf::Compression compression) {
    Imf::Header header(image.size.width, image.size.height);
    header.compression() = compression;
    for (auto const& [name, value] : image.attributes) insert_attribute(header, name, value);
    Imf::FrameBuffer buffer;
    std::deque<Outgoing> numbers; // slices point into it
    for (auto const& plane : image.planes) {
        auto const type = pixel_type(plane.type);
        header.channels().insert(plane.name, Imf::Channel(type));
        buffer.insert(plane.name, Imf::Slice::Make(type, numbers.emplace_back(file, plane).data, header.dataWindow()));
    }
    Imf::OutputFile output(stream, header, 0);
    output.setFrameBuffer(buffer);
    output.writePixels(image.size.height);
}

} // namespace detail

/// Writes a file with one part, scan lines, and each plane in its own format. The file is replaced atomically.
/// @param compression of the pixels; a lossy one also changes numbers that are no colours
/// @throws Failure naming the file and, where it is at fault, the channel
inline void write_exr(std::filesystem::path const& path, ExrImage const& image, Imf::Compression compression = Imf::ZIP_COMPRESSION) {
    auto const file = path.string();
    detail::check_writable(file, image);
    detail::MemoryStream stream(file);
    detail::naming_file<Failure>(file, "it can't be encoded", [&] { detail::encode(stream, file, image, compression); });
    replace_file(path, stream.contents());
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::io
