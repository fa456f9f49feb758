#pragma once

#include <quell/io/exr_file.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::io {

/// An EXR file of which write_copy() makes another. Unlike ExrFile it also reads what lies outside of the display window. Pixels are
/// counted from the display window's top left corner, so that overscan has negative numbers.
class ExrOriginal {
    std::unique_ptr<Imf::MultiPartInputFile> file;
    Imath::Box2i display;

public:
    /// Opens a file and reads its header.
    /// @throws Error as ExrFile does
    explicit ExrOriginal(std::filesystem::path const& path);

    ExrFile listed; ///< its channels and attributes

    /// The display window together with the data windows of all flat parts.
    [[nodiscard]] Region canvas() const;
    /// Reads these channels, each once, onto a canvas. A depth outside of the file's data window is a miss.
    /// @throws Error naming the file and the channel
    [[nodiscard]] ExrImage read(std::span<std::string const> names, Region const& canvas) const;

    /// The file's attributes, those of a part before the others.
    [[nodiscard]] std::map<std::string, Attribute, std::less<>> attributes_of(int part) const;

    /// Whether the first and the last row of each flat part can be read. A file that was cut off, or not copied whole, lacks one of them,
    /// though its header is whole.
    [[nodiscard]] bool is_whole() const;

    /// Whether a part's tiles have several levels (a mip map or rip map), so that no other numbers can be written into it.
    [[nodiscard]] bool has_levels(int part) const;

    [[nodiscard]] int parts() const { return file->parts(); }                              ///< how many parts there are
    [[nodiscard]] Imf::Header const& header(int part) const { return file->header(part); } ///< of a part, from 0
    /// The parts' pixels by the library's own interface: by Imf::InputPart and no other kind of part, which the library would confuse.
    [[nodiscard]] Imf::MultiPartInputFile& library_file() const { return *file; }
    /// A part's data window.
    [[nodiscard]] Region data_window(int part) const { return relative(file->header(part).dataWindow()); }

private:
    [[nodiscard]] Region relative(Imath::Box2i const& box) const;
};

namespace detail {

/// Whether a part holds deep data.
inline bool is_deep(Imf::Header const& header) { return header.hasType() && Imf::isDeepData(header.type()); }

inline Extent size_of(Region const& region) { return {region.x1 - region.x0, region.y1 - region.y0}; }

/// A difference of corners; windows are checked to be at most 2^28 wide, but may lie anywhere.
inline int difference(std::string const& file, int a, int b) {
    auto const exact = std::int64_t(a) - b;
    if (exact >= -max_pixels && exact <= max_pixels) return static_cast<int>(exact);
    throw Error(file, "its data window lies " + std::to_string(exact) + " pixels from its display window", "write it again");
}

inline void check_full_resolution(std::string const& file, ExrChannel const& channel) {
    if (channel.x_sampling == 1 && channel.y_sampling == 1) return;
    throw Error(file + " channel '" + channel.name + "'",
                "it is sub-sampled " + std::to_string(channel.x_sampling) + "x" + std::to_string(channel.y_sampling),
                "write it at full resolution");
}

} // namespace detail

inline ExrOriginal::ExrOriginal(std::filesystem::path const& path) : listed(path) {
    detail::naming_file(listed.name, "its header can't be read",
                        [&] { file = std::make_unique<Imf::MultiPartInputFile>(listed.name.c_str()); });
    display = file->header(0).displayWindow();
}

inline Region ExrOriginal::relative(Imath::Box2i const& box) const {
    auto const from = [&](int a, int b) { return detail::difference(listed.name, a, b); };
    return {from(box.min.x, display.min.x), from(box.min.y, display.min.y), from(box.max.x, display.min.x) + 1,
            from(box.max.y, display.min.y) + 1};
}

inline bool ExrOriginal::has_levels(int part) const {
    return header(part).hasTileDescription() && header(part).tileDescription().mode != Imf::ONE_LEVEL;
}

inline Region ExrOriginal::canvas() const {
    Region all{0, 0, listed.size.width, listed.size.height};
    for (int part = 0; part < parts(); ++part) {
        if (detail::is_deep(header(part))) continue;
        auto const data = data_window(part);
        all = {std::min(all.x0, data.x0), std::min(all.y0, data.y0), std::max(all.x1, data.x1), std::max(all.y1, data.y1)};
    }
    detail::check_window(listed.name, "whole", {{all.x0, all.y0}, {all.x1 - 1, all.y1 - 1}});
    return all;
}

inline std::map<std::string, Attribute, std::less<>> ExrOriginal::attributes_of(int part) const {
    std::map<std::string, Attribute, std::less<>> attributes;
    detail::copy_attributes(header(part), attributes);
    attributes.insert(listed.attributes.begin(), listed.attributes.end());
    return attributes;
}

inline bool ExrOriginal::is_whole() const {
    try {
        for (int part = 0; part < parts(); ++part) {
            if (detail::is_deep(header(part))) continue;
            auto const window = header(part).dataWindow();
            Imf::InputPart input(*file, part);
            auto const channel = header(part).channels().begin();
            std::vector<float> row(static_cast<std::size_t>(detail::extent_of(window).first)); // all rows go here
            Imf::FrameBuffer buffer;
            buffer.insert(channel.name(), Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(row.data() - window.min.x), sizeof(float), 0,
                                                     channel.channel().xSampling, channel.channel().ySampling));
            input.setFrameBuffer(buffer);
            input.readPixels(window.min.y);
            input.readPixels(window.max.y);
        }
        return true;
    } catch (std::exception const&) { // the base of OpenEXR's exceptions
        return false;
    }
}

inline ExrImage ExrOriginal::read(std::span<std::string const> names, Region const& canvas) const {
    std::map<int, std::vector<ExrChannel const*>> wanted;
    for (auto const& each : names) {
        auto const* const channel = listed.find(each);
        if (!channel) detail::throw_missing(listed.name, each, listed.channels);
        detail::check_full_resolution(listed.name, *channel);
        auto& of_part = wanted[channel->part];
        if (std::ranges::find(of_part, channel) == of_part.end()) of_part.push_back(channel);
    }
    ExrImage image{listed.name, detail::size_of(canvas), {}, listed.attributes};
    Imath::V2i const corner = display.min;
    Imath::Box2i const box{corner + Imath::V2i(canvas.x0, canvas.y0), corner + Imath::V2i(canvas.x1 - 1, canvas.y1 - 1)};
    for (auto const& [part, of_part] : wanted) detail::read_part(*file, listed.name, part, of_part, box, image);
    return image;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::io
