#include "report/check.hpp"

#include "quell/core/error.hpp"

#include <algorithm>
#include <cstddef>
#include <set>

namespace quell::examples {

namespace {

void check_kinds(std::vector<PictureKind> const& kinds) {
    std::set<std::string> names;
    for (PictureKind const& kind : kinds) {
        if (!names.insert(kind.name).second)
            throw Failure("picture kind \"" + kind.name + "\"", "is listed twice", "give each kind a name of its own");
        if (kind.scale && kind.scale->colors.size() < 2)
            throw Failure("color scale of \"" + kind.name + "\"", "has fewer than two colors", "give it one for each end at least");
    }
}

void check_frames(Report const& report) {
    ReportFrame const* previous = nullptr;
    for (ReportFrame const& frame : report.frames) {
        std::string const subject = "frame " + std::to_string(frame.number);
        if (previous && previous->number >= frame.number)
            throw Failure(subject, "comes after frame " + std::to_string(previous->number), "list each frame once, by ascending number");
        for (auto const& [name, png] : frame.pictures) {
            if (std::ranges::find(report.kinds, name, &PictureKind::name) == report.kinds.end())
                throw Failure(subject, "has a picture of the unknown kind \"" + name + "\"", "list the kind in Report::kinds");
            png_size(png, "picture \"" + name + "\" of " + subject);
        }
        previous = &frame;
    }
}

void check_tables(std::vector<ReportTable> const& tables) {
    for (ReportTable const& table : tables)
        for (std::vector<std::string> const& row : table.rows)
            if (row.size() != table.columns.size())
                throw Failure("table \"" + table.caption + "\"",
                              "has a row of " + std::to_string(row.size()) + " cells under " + std::to_string(table.columns.size()) +
                                  " columns",
                              "give every row a cell for each column");
}

} // namespace

PictureSize png_size(std::vector<unsigned char> const& bytes, std::string const& subject) {
    // The signature, then the length and the name of the header chunk, whose first two words are the width and the height.
    static constexpr unsigned char signature[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    if (bytes.size() < 24 || !std::equal(std::begin(signature), std::end(signature), bytes.begin()))
        throw Failure(subject, "isn't a PNG file (" + std::to_string(bytes.size()) + " bytes)", "encode it as PNG");
    auto const word = [&](std::size_t at) {
        return static_cast<unsigned>(bytes[at]) << 24 | static_cast<unsigned>(bytes[at + 1]) << 16 |
               static_cast<unsigned>(bytes[at + 2]) << 8 | static_cast<unsigned>(bytes[at + 3]);
    };
    PictureSize const size{word(16), word(20)};
    if (size.width == 0 || size.height == 0) throw Failure(subject, "is a PNG file without pixels", "give it a size");
    return size;
}

void check_report(Report const& report) {
    check_kinds(report.kinds);
    check_frames(report);
    check_tables(report.tables);
}

} // namespace quell::examples
