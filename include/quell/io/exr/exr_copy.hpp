#pragma once

#include <quell/io/exr/copied_part.hpp>
#include <quell/io/exr/exr_original.hpp>

#include <functional>

namespace quell::inline QUELL_INSTRUCTION_SET::io {

/// What a copy of an EXR file has in place of, or beside, what the file has.
struct ExrChanges {
    Region canvas;                        ///< what `numbers` cover, counted from the display window's corner
    std::vector<NewNumbers> numbers = {}; ///< for channels; one that the file lacks is added
    /// Whether the copy has a channel of the file; by default it has all. Asked with the part's name, which may be empty.
    std::function<bool(std::string const& part, std::string const& channel)> keeps = [](auto const&, auto const&) { return true; };
    /// A channel within a part that is data, whatever it is called.
    struct Guide {
        int part = 0;        ///< index of the part
        std::string channel; ///< name within the part
    };
    std::vector<Guide> guides = {}; ///< which no compression may change
};

/// Writes a copy of an EXR file with other numbers in some of its channels. Everything else stays: parts, windows, tiles, line order,
/// compression, attributes and number formats. Parts without new numbers are copied in their compressed form, deep ones too. In other parts
/// the channels are packed again. Where a lossy compression would so change numbers that are no colours (depth, ids, Cryptomatte), or make
/// light infinite, that part is packed without loss (ZIP). The file is replaced atomically.
/// @returns names of the parts that are packed without loss for that reason; a part's number where it has no name
/// @throws Error naming the file and, where it is at fault, the channel; a Failure where the original is not at fault
inline std::vector<std::string> write_copy(std::filesystem::path const& path, ExrOriginal const& original, ExrChanges const& changes);

namespace detail {

/// Parts of the copy that have at least one channel.
inline std::vector<CopiedPart> copied_parts(ExrOriginal const& original, ExrChanges const& changes) {
    std::vector<CopiedPart> parts;
    for (int number = 0; number < original.parts(); ++number) {
        CopiedPart part(number, original.header(number));
        part.keep_channels(changes.keeps);
        for (auto const& each : changes.numbers)
            if (each.part == number) part.add(each);
        for (auto const& guide : changes.guides)
            if (guide.part == number) part.add_guide(guide.channel);
        if (part.header.channels().begin() != part.header.channels().end()) parts.push_back(std::move(part));
    }
    if (parts.empty()) throw Error(original.listed.name, "its copy would have no channels", "keep at least one layer");
    return parts;
}

inline std::string encoded(std::string const& file, ExrOriginal const& original, Region const& canvas,
                           std::vector<CopiedPart> const& parts) {
    MemoryStream stream(file);
    std::vector<Imf::Header> headers;
    for (auto const& part : parts) headers.push_back(part.header);
    Imf::MultiPartInputFile from(original.listed.name.c_str());
    {
        Imf::MultiPartOutputFile output(stream, headers.data(), static_cast<int>(headers.size()));
        for (int i = 0; auto const& part : parts) part.write(original, from, canvas, output, i++);
    }
    return stream.contents();
}

/// Makes parts lossless that packing harms. Returns their names.
inline std::vector<std::string> keep_data(std::string const& file, ExrOriginal const& original, Region const& canvas,
                                          std::string const& bytes, std::vector<CopiedPart>& parts) {
    std::vector<std::string> changed;
    MemoryInput input(file, bytes);
    Imf::MultiPartInputFile copy(input);
    for (int i = 0; auto& part : parts) {
        if (part.is_touched() && part.is_lossy() && part.is_harmed(original, canvas, copy, i)) {
            part.header.compression() = Imf::ZIP_COMPRESSION;
            changed.push_back(part.header.hasName() ? part.header.name() : std::to_string(part.number));
        }
        ++i;
    }
    return changed;
}

} // namespace detail

inline std::vector<std::string> write_copy(std::filesystem::path const& path, ExrOriginal const& original, ExrChanges const& changes) {
    auto const file = path.string();
    std::vector<std::string> lossless;
    std::string bytes;
    detail::naming_file<Failure>(file, "a copy of " + original.listed.name + " can't be encoded", [&] {
        auto parts = detail::copied_parts(original, changes);
        bytes = detail::encoded(file, original, changes.canvas, parts);
        lossless = detail::keep_data(file, original, changes.canvas, bytes, parts);
        if (!lossless.empty()) bytes = detail::encoded(file, original, changes.canvas, parts);
    });
    replace_file(path, bytes);
    return lossless;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::io
