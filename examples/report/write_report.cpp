#include "report/report.hpp"

#include "report/base64.hpp"
#include "report/check.hpp"
#include "report/page_data.hpp"
#include "report/page_parts.hpp"

#include "quell/core/error.hpp"

#include <fstream>
#include <string_view>
#include <system_error>
#include <utility>

namespace quell::examples {

namespace {

std::string escape_html(std::string_view text) {
    std::string escaped;
    for (char const character : text) {
        switch (character) {
        case '&':
            escaped += "&amp;";
            break;
        case '<':
            escaped += "&lt;";
            break;
        case '>':
            escaped += "&gt;";
            break;
        default:
            escaped += character;
        }
    }
    return escaped;
}

/// One element per picture, so that a browser holds no decoded copy of those that nobody looks at.
void write_pictures(std::ostream& out, PageData const& data) {
    for (std::size_t i = 0; i < data.pictures.size(); ++i)
        out << "<script type=\"text/plain\" id=\"picture-" << i << "\">data:image/png;base64," << encode_base64(*data.pictures[i])
            << "</script>\n";
}

void write_part(std::ostream& out, std::string_view mark, Report const& report, PageData const& data) {
    if (mark == "title") out << escape_html(report.title);
    if (mark == "style") out << page_style();
    if (mark == "data") out << data.json;
    if (mark == "pictures") write_pictures(out, data);
    if (mark == "scripts")
        for (std::string_view const script : page_scripts()) out << script;
}

/// Writes the page's HTML with each {{mark}} replaced.
void write_page(std::ostream& out, Report const& report) {
    PageData const data = page_data(report);
    std::string_view rest = page_html();
    for (std::size_t open = rest.find("{{"); open != std::string_view::npos; open = rest.find("{{")) {
        std::size_t const close = rest.find("}}", open);
        out << rest.substr(0, open);
        write_part(out, rest.substr(open + 2, close - open - 2), report, data);
        rest.remove_prefix(close + 2);
    }
    out << rest;
}

[[noreturn]] void fail(std::filesystem::path const& file, std::string const& found) {
    throw Error(file.string(), found, "check that its folder exists, may be written to and has room left");
}

void write_partial(Report const& report, std::filesystem::path const& file, std::filesystem::path const& partial) {
    std::ofstream out(partial, std::ios::binary);
    if (!out) fail(file, "can't be opened for writing");
    write_page(out, report);
    out.close();
    if (!out) fail(file, "can't be written in full");
}

/// Removes a half-written file, except where it has been put in place.
class PartialFile {
public:
    explicit PartialFile(std::filesystem::path path) : path_(std::move(path)) {}
    PartialFile(PartialFile const&) = delete;
    PartialFile& operator=(PartialFile const&) = delete;
    ~PartialFile() {
        std::error_code ignored;
        if (std::filesystem::is_regular_file(path_, ignored)) std::filesystem::remove(path_, ignored);
    }

    std::filesystem::path const& path() const { return path_; }

private:
    std::filesystem::path path_;
};

} // namespace

void write_report(Report const& report, std::filesystem::path const& file) {
    check_report(report);
    PartialFile const partial(std::filesystem::path(file) += ".partial");
    write_partial(report, file, partial.path());
    std::error_code error;
    std::filesystem::rename(partial.path(), file, error);
    if (error) fail(file, "can't be put in place: " + error.message());
}

} // namespace quell::examples
